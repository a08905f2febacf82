/* One C function per method of mien.RawJni. Written by abi/generate_bindings.py. */
/* clang-format off */

STATIC_CHECK(sizeof(mien_error) == 272, size_of_mien_error);
STATIC_CHECK(offsetof(mien_error, struct_size) == 0, place_of_mien_error_struct_size);
STATIC_CHECK(offsetof(mien_error, status) == 4, place_of_mien_error_status);
STATIC_CHECK(offsetof(mien_error, detail_index) == 8, place_of_mien_error_detail_index);
STATIC_CHECK(offsetof(mien_error, message) == 16, place_of_mien_error_message);
STATIC_CHECK(sizeof(mien_session_options) == 48, size_of_mien_session_options);
STATIC_CHECK(offsetof(mien_session_options, struct_size) == 0, place_of_mien_session_options_struct_size);
STATIC_CHECK(offsetof(mien_session_options, num_threads) == 4, place_of_mien_session_options_num_threads);
STATIC_CHECK(offsetof(mien_session_options, max_bytes) == 8, place_of_mien_session_options_max_bytes);
STATIC_CHECK(offsetof(mien_session_options, log) == 16, place_of_mien_session_options_log);
STATIC_CHECK(offsetof(mien_session_options, log_user) == 24, place_of_mien_session_options_log_user);
STATIC_CHECK(offsetof(mien_session_options, max_seconds) == 32, place_of_mien_session_options_max_seconds);
STATIC_CHECK(offsetof(mien_session_options, copy_files) == 40, place_of_mien_session_options_copy_files);
STATIC_CHECK(offsetof(mien_session_options, reserved) == 44, place_of_mien_session_options_reserved);
STATIC_CHECK(sizeof(mien_array_view) == 32, size_of_mien_array_view);
STATIC_CHECK(offsetof(mien_array_view, data) == 0, place_of_mien_array_view_data);
STATIC_CHECK(offsetof(mien_array_view, count) == 8, place_of_mien_array_view_count);
STATIC_CHECK(offsetof(mien_array_view, stride_bytes) == 16, place_of_mien_array_view_stride_bytes);
STATIC_CHECK(offsetof(mien_array_view, dtype) == 24, place_of_mien_array_view_dtype);
STATIC_CHECK(offsetof(mien_array_view, reserved) == 28, place_of_mien_array_view_reserved);
STATIC_CHECK(sizeof(mien_zone) == 24, size_of_mien_zone);
STATIC_CHECK(offsetof(mien_zone, name) == 0, place_of_mien_zone_name);
STATIC_CHECK(offsetof(mien_zone, vertices) == 8, place_of_mien_zone_vertices);
STATIC_CHECK(offsetof(mien_zone, vertex_count) == 16, place_of_mien_zone_vertex_count);
STATIC_CHECK(sizeof(mien_image) == 48, size_of_mien_image);
STATIC_CHECK(offsetof(mien_image, name) == 0, place_of_mien_image_name);
STATIC_CHECK(offsetof(mien_image, pixels) == 8, place_of_mien_image_pixels);
STATIC_CHECK(offsetof(mien_image, row_stride_bytes) == 16, place_of_mien_image_row_stride_bytes);
STATIC_CHECK(offsetof(mien_image, width) == 24, place_of_mien_image_width);
STATIC_CHECK(offsetof(mien_image, height) == 28, place_of_mien_image_height);
STATIC_CHECK(offsetof(mien_image, file) == 32, place_of_mien_image_file);
STATIC_CHECK(offsetof(mien_image, file_size) == 40, place_of_mien_image_file_size);
STATIC_CHECK(sizeof(mien_material) == 40, size_of_mien_material);
STATIC_CHECK(offsetof(mien_material, name) == 0, place_of_mien_material_name);
STATIC_CHECK(offsetof(mien_material, image) == 8, place_of_mien_material_image);
STATIC_CHECK(offsetof(mien_material, reserved) == 12, place_of_mien_material_reserved);
STATIC_CHECK(offsetof(mien_material, red) == 16, place_of_mien_material_red);
STATIC_CHECK(offsetof(mien_material, green) == 24, place_of_mien_material_green);
STATIC_CHECK(offsetof(mien_material, blue) == 32, place_of_mien_material_blue);
STATIC_CHECK(sizeof(mien_mesh_arrays) == 128, size_of_mien_mesh_arrays);
STATIC_CHECK(offsetof(mien_mesh_arrays, struct_size) == 0, place_of_mien_mesh_arrays_struct_size);
STATIC_CHECK(offsetof(mien_mesh_arrays, reserved) == 4, place_of_mien_mesh_arrays_reserved);
STATIC_CHECK(offsetof(mien_mesh_arrays, positions) == 8, place_of_mien_mesh_arrays_positions);
STATIC_CHECK(offsetof(mien_mesh_arrays, triangles) == 40, place_of_mien_mesh_arrays_triangles);
STATIC_CHECK(offsetof(mien_mesh_arrays, triangle_count) == 48, place_of_mien_mesh_arrays_triangle_count);
STATIC_CHECK(offsetof(mien_mesh_arrays, colors) == 56, place_of_mien_mesh_arrays_colors);
STATIC_CHECK(offsetof(mien_mesh_arrays, texture) == 64, place_of_mien_mesh_arrays_texture);
STATIC_CHECK(offsetof(mien_mesh_arrays, texture_count) == 72, place_of_mien_mesh_arrays_texture_count);
STATIC_CHECK(offsetof(mien_mesh_arrays, texture_triangles) == 80, place_of_mien_mesh_arrays_texture_triangles);
STATIC_CHECK(offsetof(mien_mesh_arrays, materials) == 88, place_of_mien_mesh_arrays_materials);
STATIC_CHECK(offsetof(mien_mesh_arrays, material_count) == 96, place_of_mien_mesh_arrays_material_count);
STATIC_CHECK(offsetof(mien_mesh_arrays, triangle_materials) == 104, place_of_mien_mesh_arrays_triangle_materials);
STATIC_CHECK(offsetof(mien_mesh_arrays, images) == 112, place_of_mien_mesh_arrays_images);
STATIC_CHECK(offsetof(mien_mesh_arrays, image_count) == 120, place_of_mien_mesh_arrays_image_count);
STATIC_CHECK(sizeof(mien_kernel) == 32, size_of_mien_kernel);
STATIC_CHECK(offsetof(mien_kernel, kind) == 0, place_of_mien_kernel_kind);
STATIC_CHECK(offsetof(mien_kernel, reserved) == 4, place_of_mien_kernel_reserved);
STATIC_CHECK(offsetof(mien_kernel, sigma_mm) == 8, place_of_mien_kernel_sigma_mm);
STATIC_CHECK(offsetof(mien_kernel, scale_mm) == 16, place_of_mien_kernel_scale_mm);
STATIC_CHECK(offsetof(mien_kernel, nu) == 24, place_of_mien_kernel_nu);
STATIC_CHECK(sizeof(mien_landmark) == 16, size_of_mien_landmark);
STATIC_CHECK(offsetof(mien_landmark, name) == 0, place_of_mien_landmark_name);
STATIC_CHECK(offsetof(mien_landmark, vertex) == 8, place_of_mien_landmark_vertex);
STATIC_CHECK(offsetof(mien_landmark, reserved) == 12, place_of_mien_landmark_reserved);
STATIC_CHECK(sizeof(mien_landmark_observation) == 48, size_of_mien_landmark_observation);
STATIC_CHECK(offsetof(mien_landmark_observation, name) == 0, place_of_mien_landmark_observation_name);
STATIC_CHECK(offsetof(mien_landmark_observation, vertex) == 8, place_of_mien_landmark_observation_vertex);
STATIC_CHECK(offsetof(mien_landmark_observation, reserved) == 12, place_of_mien_landmark_observation_reserved);
STATIC_CHECK(offsetof(mien_landmark_observation, position) == 16, place_of_mien_landmark_observation_position);
STATIC_CHECK(offsetof(mien_landmark_observation, noise_mm) == 40, place_of_mien_landmark_observation_noise_mm);
STATIC_CHECK(sizeof(mien_model_options) == 216, size_of_mien_model_options);
STATIC_CHECK(offsetof(mien_model_options, struct_size) == 0, place_of_mien_model_options_struct_size);
STATIC_CHECK(offsetof(mien_model_options, kernel) == 4, place_of_mien_model_options_kernel);
STATIC_CHECK(offsetof(mien_model_options, sigma_mm) == 8, place_of_mien_model_options_sigma_mm);
STATIC_CHECK(offsetof(mien_model_options, scale_mm) == 16, place_of_mien_model_options_scale_mm);
STATIC_CHECK(offsetof(mien_model_options, nu) == 24, place_of_mien_model_options_nu);
STATIC_CHECK(offsetof(mien_model_options, levels) == 32, place_of_mien_model_options_levels);
STATIC_CHECK(offsetof(mien_model_options, num_modes) == 36, place_of_mien_model_options_num_modes);
STATIC_CHECK(offsetof(mien_model_options, kernels) == 40, place_of_mien_model_options_kernels);
STATIC_CHECK(offsetof(mien_model_options, kernel_count) == 48, place_of_mien_model_options_kernel_count);
STATIC_CHECK(offsetof(mien_model_options, tolerance) == 56, place_of_mien_model_options_tolerance);
STATIC_CHECK(offsetof(mien_model_options, num_control_points) == 64, place_of_mien_model_options_num_control_points);
STATIC_CHECK(offsetof(mien_model_options, mirror_symmetric) == 68, place_of_mien_model_options_mirror_symmetric);
STATIC_CHECK(offsetof(mien_model_options, mirror_correlation) == 72, place_of_mien_model_options_mirror_correlation);
STATIC_CHECK(offsetof(mien_model_options, eigenvalue_threshold) == 80, place_of_mien_model_options_eigenvalue_threshold);
STATIC_CHECK(offsetof(mien_model_options, heat_time_factor) == 88, place_of_mien_model_options_heat_time_factor);
STATIC_CHECK(offsetof(mien_model_options, heat_boundary) == 96, place_of_mien_model_options_heat_boundary);
STATIC_CHECK(offsetof(mien_model_options, pca_modes) == 100, place_of_mien_model_options_pca_modes);
STATIC_CHECK(offsetof(mien_model_options, pca_dataset) == 104, place_of_mien_model_options_pca_dataset);
STATIC_CHECK(offsetof(mien_model_options, pca_variance) == 112, place_of_mien_model_options_pca_variance);
STATIC_CHECK(offsetof(mien_model_options, pca_all_expressions) == 120, place_of_mien_model_options_pca_all_expressions);
STATIC_CHECK(offsetof(mien_model_options, pca_align) == 124, place_of_mien_model_options_pca_align);
STATIC_CHECK(offsetof(mien_model_options, scale_per_vertex) == 128, place_of_mien_model_options_scale_per_vertex);
STATIC_CHECK(offsetof(mien_model_options, landmarks) == 160, place_of_mien_model_options_landmarks);
STATIC_CHECK(offsetof(mien_model_options, landmark_count) == 168, place_of_mien_model_options_landmark_count);
STATIC_CHECK(offsetof(mien_model_options, zones) == 176, place_of_mien_model_options_zones);
STATIC_CHECK(offsetof(mien_model_options, zone_count) == 184, place_of_mien_model_options_zone_count);
STATIC_CHECK(offsetof(mien_model_options, progress) == 192, place_of_mien_model_options_progress);
STATIC_CHECK(offsetof(mien_model_options, progress_user) == 200, place_of_mien_model_options_progress_user);
STATIC_CHECK(offsetof(mien_model_options, cancel) == 208, place_of_mien_model_options_cancel);
STATIC_CHECK(sizeof(mien_tune_options) == 128, size_of_mien_tune_options);
STATIC_CHECK(offsetof(mien_tune_options, struct_size) == 0, place_of_mien_tune_options_struct_size);
STATIC_CHECK(offsetof(mien_tune_options, kernel) == 4, place_of_mien_tune_options_kernel);
STATIC_CHECK(offsetof(mien_tune_options, sigmas_mm) == 8, place_of_mien_tune_options_sigmas_mm);
STATIC_CHECK(offsetof(mien_tune_options, sigma_count) == 16, place_of_mien_tune_options_sigma_count);
STATIC_CHECK(offsetof(mien_tune_options, scale_mm) == 24, place_of_mien_tune_options_scale_mm);
STATIC_CHECK(offsetof(mien_tune_options, nu) == 32, place_of_mien_tune_options_nu);
STATIC_CHECK(offsetof(mien_tune_options, rho) == 40, place_of_mien_tune_options_rho);
STATIC_CHECK(offsetof(mien_tune_options, levels) == 48, place_of_mien_tune_options_levels);
STATIC_CHECK(offsetof(mien_tune_options, num_modes) == 52, place_of_mien_tune_options_num_modes);
STATIC_CHECK(offsetof(mien_tune_options, expressions) == 56, place_of_mien_tune_options_expressions);
STATIC_CHECK(offsetof(mien_tune_options, expression_count) == 64, place_of_mien_tune_options_expression_count);
STATIC_CHECK(offsetof(mien_tune_options, max_subjects) == 68, place_of_mien_tune_options_max_subjects);
STATIC_CHECK(offsetof(mien_tune_options, progress) == 72, place_of_mien_tune_options_progress);
STATIC_CHECK(offsetof(mien_tune_options, progress_user) == 80, place_of_mien_tune_options_progress_user);
STATIC_CHECK(offsetof(mien_tune_options, cancel) == 88, place_of_mien_tune_options_cancel);
STATIC_CHECK(offsetof(mien_tune_options, scales_mm) == 96, place_of_mien_tune_options_scales_mm);
STATIC_CHECK(offsetof(mien_tune_options, scale_count) == 104, place_of_mien_tune_options_scale_count);
STATIC_CHECK(offsetof(mien_tune_options, level_counts) == 112, place_of_mien_tune_options_level_counts);
STATIC_CHECK(offsetof(mien_tune_options, level_count) == 120, place_of_mien_tune_options_level_count);
STATIC_CHECK(sizeof(mien_scan_landmark) == 32, size_of_mien_scan_landmark);
STATIC_CHECK(offsetof(mien_scan_landmark, name) == 0, place_of_mien_scan_landmark_name);
STATIC_CHECK(offsetof(mien_scan_landmark, position) == 8, place_of_mien_scan_landmark_position);
STATIC_CHECK(sizeof(mien_anthropometry_options) == 120, size_of_mien_anthropometry_options);
STATIC_CHECK(offsetof(mien_anthropometry_options, struct_size) == 0, place_of_mien_anthropometry_options_struct_size);
STATIC_CHECK(offsetof(mien_anthropometry_options, reserved) == 4, place_of_mien_anthropometry_options_reserved);
STATIC_CHECK(offsetof(mien_anthropometry_options, place_sd) == 8, place_of_mien_anthropometry_options_place_sd);
STATIC_CHECK(offsetof(mien_anthropometry_options, normal_sd) == 40, place_of_mien_anthropometry_options_normal_sd);
STATIC_CHECK(offsetof(mien_anthropometry_options, slide_correlation_mm) == 72, place_of_mien_anthropometry_options_slide_correlation_mm);
STATIC_CHECK(offsetof(mien_anthropometry_options, normal_correlation_mm) == 80, place_of_mien_anthropometry_options_normal_correlation_mm);
STATIC_CHECK(offsetof(mien_anthropometry_options, norms) == 88, place_of_mien_anthropometry_options_norms);
STATIC_CHECK(offsetof(mien_anthropometry_options, progress) == 96, place_of_mien_anthropometry_options_progress);
STATIC_CHECK(offsetof(mien_anthropometry_options, progress_user) == 104, place_of_mien_anthropometry_options_progress_user);
STATIC_CHECK(offsetof(mien_anthropometry_options, cancel) == 112, place_of_mien_anthropometry_options_cancel);
STATIC_CHECK(sizeof(mien_anthropometric_value) == 64, size_of_mien_anthropometric_value);
STATIC_CHECK(offsetof(mien_anthropometric_value, struct_size) == 0, place_of_mien_anthropometric_value_struct_size);
STATIC_CHECK(offsetof(mien_anthropometric_value, kind) == 4, place_of_mien_anthropometric_value_kind);
STATIC_CHECK(offsetof(mien_anthropometric_value, value) == 8, place_of_mien_anthropometric_value_value);
STATIC_CHECK(offsetof(mien_anthropometric_value, sd) == 16, place_of_mien_anthropometric_value_sd);
STATIC_CHECK(offsetof(mien_anthropometric_value, z) == 24, place_of_mien_anthropometric_value_z);
STATIC_CHECK(offsetof(mien_anthropometric_value, z_sd) == 32, place_of_mien_anthropometric_value_z_sd);
STATIC_CHECK(offsetof(mien_anthropometric_value, norm_mean) == 40, place_of_mien_anthropometric_value_norm_mean);
STATIC_CHECK(offsetof(mien_anthropometric_value, norm_sd) == 48, place_of_mien_anthropometric_value_norm_sd);
STATIC_CHECK(offsetof(mien_anthropometric_value, norm_people) == 56, place_of_mien_anthropometric_value_norm_people);
STATIC_CHECK(sizeof(mien_measure_options) == 184, size_of_mien_measure_options);
STATIC_CHECK(offsetof(mien_measure_options, struct_size) == 0, place_of_mien_measure_options_struct_size);
STATIC_CHECK(offsetof(mien_measure_options, skip_borders) == 4, place_of_mien_measure_options_skip_borders);
STATIC_CHECK(offsetof(mien_measure_options, zones) == 8, place_of_mien_measure_options_zones);
STATIC_CHECK(offsetof(mien_measure_options, zone_count) == 16, place_of_mien_measure_options_zone_count);
STATIC_CHECK(offsetof(mien_measure_options, before_sd) == 24, place_of_mien_measure_options_before_sd);
STATIC_CHECK(offsetof(mien_measure_options, after_sd) == 56, place_of_mien_measure_options_after_sd);
STATIC_CHECK(offsetof(mien_measure_options, correlation_length_mm) == 88, place_of_mien_measure_options_correlation_length_mm);
STATIC_CHECK(offsetof(mien_measure_options, alignment_rotation_sd_rad) == 96, place_of_mien_measure_options_alignment_rotation_sd_rad);
STATIC_CHECK(offsetof(mien_measure_options, alignment_translation_sd_mm) == 104, place_of_mien_measure_options_alignment_translation_sd_mm);
STATIC_CHECK(offsetof(mien_measure_options, alignment_centre) == 112, place_of_mien_measure_options_alignment_centre);
STATIC_CHECK(offsetof(mien_measure_options, common_bias_mm) == 136, place_of_mien_measure_options_common_bias_mm);
STATIC_CHECK(offsetof(mien_measure_options, limit_of_detection_ml) == 144, place_of_mien_measure_options_limit_of_detection_ml);
STATIC_CHECK(offsetof(mien_measure_options, max_distance_mm) == 152, place_of_mien_measure_options_max_distance_mm);
STATIC_CHECK(offsetof(mien_measure_options, progress) == 160, place_of_mien_measure_options_progress);
STATIC_CHECK(offsetof(mien_measure_options, progress_user) == 168, place_of_mien_measure_options_progress_user);
STATIC_CHECK(offsetof(mien_measure_options, cancel) == 176, place_of_mien_measure_options_cancel);
STATIC_CHECK(sizeof(mien_zone_volume) == 80, size_of_mien_zone_volume);
STATIC_CHECK(offsetof(mien_zone_volume, struct_size) == 0, place_of_mien_zone_volume_struct_size);
STATIC_CHECK(offsetof(mien_zone_volume, detected) == 4, place_of_mien_zone_volume_detected);
STATIC_CHECK(offsetof(mien_zone_volume, signed_ml) == 8, place_of_mien_zone_volume_signed_ml);
STATIC_CHECK(offsetof(mien_zone_volume, positive_ml) == 16, place_of_mien_zone_volume_positive_ml);
STATIC_CHECK(offsetof(mien_zone_volume, negative_ml) == 24, place_of_mien_zone_volume_negative_ml);
STATIC_CHECK(offsetof(mien_zone_volume, absolute_ml) == 32, place_of_mien_zone_volume_absolute_ml);
STATIC_CHECK(offsetof(mien_zone_volume, sd_ml) == 40, place_of_mien_zone_volume_sd_ml);
STATIC_CHECK(offsetof(mien_zone_volume, low95_ml) == 48, place_of_mien_zone_volume_low95_ml);
STATIC_CHECK(offsetof(mien_zone_volume, high95_ml) == 56, place_of_mien_zone_volume_high95_ml);
STATIC_CHECK(offsetof(mien_zone_volume, area_before_mm2) == 64, place_of_mien_zone_volume_area_before_mm2);
STATIC_CHECK(offsetof(mien_zone_volume, area_after_mm2) == 72, place_of_mien_zone_volume_area_after_mm2);
STATIC_CHECK(sizeof(mien_zone_distance) == 80, size_of_mien_zone_distance);
STATIC_CHECK(offsetof(mien_zone_distance, struct_size) == 0, place_of_mien_zone_distance_struct_size);
STATIC_CHECK(offsetof(mien_zone_distance, reserved) == 4, place_of_mien_zone_distance_reserved);
STATIC_CHECK(offsetof(mien_zone_distance, mean_signed_mm) == 8, place_of_mien_zone_distance_mean_signed_mm);
STATIC_CHECK(offsetof(mien_zone_distance, sd_signed_mm) == 16, place_of_mien_zone_distance_sd_signed_mm);
STATIC_CHECK(offsetof(mien_zone_distance, mean_absolute_mm) == 24, place_of_mien_zone_distance_mean_absolute_mm);
STATIC_CHECK(offsetof(mien_zone_distance, rms_mm) == 32, place_of_mien_zone_distance_rms_mm);
STATIC_CHECK(offsetof(mien_zone_distance, mean_length_mm) == 40, place_of_mien_zone_distance_mean_length_mm);
STATIC_CHECK(offsetof(mien_zone_distance, median_length_mm) == 48, place_of_mien_zone_distance_median_length_mm);
STATIC_CHECK(offsetof(mien_zone_distance, p95_length_mm) == 56, place_of_mien_zone_distance_p95_length_mm);
STATIC_CHECK(offsetof(mien_zone_distance, max_length_mm) == 64, place_of_mien_zone_distance_max_length_mm);
STATIC_CHECK(offsetof(mien_zone_distance, vertex_count) == 72, place_of_mien_zone_distance_vertex_count);
STATIC_CHECK(sizeof(mien_zone_alignment) == 192, size_of_mien_zone_alignment);
STATIC_CHECK(offsetof(mien_zone_alignment, struct_size) == 0, place_of_mien_zone_alignment_struct_size);
STATIC_CHECK(offsetof(mien_zone_alignment, reserved) == 4, place_of_mien_zone_alignment_reserved);
STATIC_CHECK(offsetof(mien_zone_alignment, pairs) == 8, place_of_mien_zone_alignment_pairs);
STATIC_CHECK(offsetof(mien_zone_alignment, rms_mm) == 16, place_of_mien_zone_alignment_rms_mm);
STATIC_CHECK(offsetof(mien_zone_alignment, rotation_sd_rad) == 24, place_of_mien_zone_alignment_rotation_sd_rad);
STATIC_CHECK(offsetof(mien_zone_alignment, translation_sd_mm) == 32, place_of_mien_zone_alignment_translation_sd_mm);
STATIC_CHECK(offsetof(mien_zone_alignment, centre) == 40, place_of_mien_zone_alignment_centre);
STATIC_CHECK(offsetof(mien_zone_alignment, matrix) == 64, place_of_mien_zone_alignment_matrix);
STATIC_CHECK(sizeof(mien_asymmetry_options) == 96, size_of_mien_asymmetry_options);
STATIC_CHECK(offsetof(mien_asymmetry_options, struct_size) == 0, place_of_mien_asymmetry_options_struct_size);
STATIC_CHECK(offsetof(mien_asymmetry_options, plane) == 4, place_of_mien_asymmetry_options_plane);
STATIC_CHECK(offsetof(mien_asymmetry_options, zones) == 8, place_of_mien_asymmetry_options_zones);
STATIC_CHECK(offsetof(mien_asymmetry_options, zone_count) == 16, place_of_mien_asymmetry_options_zone_count);
STATIC_CHECK(offsetof(mien_asymmetry_options, landmarks) == 24, place_of_mien_asymmetry_options_landmarks);
STATIC_CHECK(offsetof(mien_asymmetry_options, normal_sd) == 32, place_of_mien_asymmetry_options_normal_sd);
STATIC_CHECK(offsetof(mien_asymmetry_options, correlation_length_mm) == 64, place_of_mien_asymmetry_options_correlation_length_mm);
STATIC_CHECK(offsetof(mien_asymmetry_options, progress) == 72, place_of_mien_asymmetry_options_progress);
STATIC_CHECK(offsetof(mien_asymmetry_options, progress_user) == 80, place_of_mien_asymmetry_options_progress_user);
STATIC_CHECK(offsetof(mien_asymmetry_options, cancel) == 88, place_of_mien_asymmetry_options_cancel);
STATIC_CHECK(sizeof(mien_mirror_plane) == 104, size_of_mien_mirror_plane);
STATIC_CHECK(offsetof(mien_mirror_plane, struct_size) == 0, place_of_mien_mirror_plane_struct_size);
STATIC_CHECK(offsetof(mien_mirror_plane, by) == 4, place_of_mien_mirror_plane_by);
STATIC_CHECK(offsetof(mien_mirror_plane, pairs) == 8, place_of_mien_mirror_plane_pairs);
STATIC_CHECK(offsetof(mien_mirror_plane, normal) == 16, place_of_mien_mirror_plane_normal);
STATIC_CHECK(offsetof(mien_mirror_plane, centre) == 40, place_of_mien_mirror_plane_centre);
STATIC_CHECK(offsetof(mien_mirror_plane, rms_mm) == 64, place_of_mien_mirror_plane_rms_mm);
STATIC_CHECK(offsetof(mien_mirror_plane, tilt_sd_rad) == 72, place_of_mien_mirror_plane_tilt_sd_rad);
STATIC_CHECK(offsetof(mien_mirror_plane, offset_sd_mm) == 80, place_of_mien_mirror_plane_offset_sd_mm);
STATIC_CHECK(offsetof(mien_mirror_plane, between_rad) == 88, place_of_mien_mirror_plane_between_rad);
STATIC_CHECK(offsetof(mien_mirror_plane, apart_mm) == 96, place_of_mien_mirror_plane_apart_mm);
STATIC_CHECK(sizeof(mien_register_options) == 296, size_of_mien_register_options);
STATIC_CHECK(offsetof(mien_register_options, struct_size) == 0, place_of_mien_register_options_struct_size);
STATIC_CHECK(offsetof(mien_register_options, growth) == 4, place_of_mien_register_options_growth);
STATIC_CHECK(offsetof(mien_register_options, landmarks) == 8, place_of_mien_register_options_landmarks);
STATIC_CHECK(offsetof(mien_register_options, landmark_count) == 16, place_of_mien_register_options_landmark_count);
STATIC_CHECK(offsetof(mien_register_options, landmark_sigma_mm) == 24, place_of_mien_register_options_landmark_sigma_mm);
STATIC_CHECK(offsetof(mien_register_options, start) == 32, place_of_mien_register_options_start);
STATIC_CHECK(offsetof(mien_register_options, units) == 36, place_of_mien_register_options_units);
STATIC_CHECK(offsetof(mien_register_options, scan_weights) == 40, place_of_mien_register_options_scan_weights);
STATIC_CHECK(offsetof(mien_register_options, skin_weights) == 72, place_of_mien_register_options_skin_weights);
STATIC_CHECK(offsetof(mien_register_options, close_gap) == 76, place_of_mien_register_options_close_gap);
STATIC_CHECK(offsetof(mien_register_options, max_scalar_modes) == 80, place_of_mien_register_options_max_scalar_modes);
STATIC_CHECK(offsetof(mien_register_options, max_pca_modes) == 84, place_of_mien_register_options_max_pca_modes);
STATIC_CHECK(offsetof(mien_register_options, iterations) == 88, place_of_mien_register_options_iterations);
STATIC_CHECK(offsetof(mien_register_options, reject_border) == 92, place_of_mien_register_options_reject_border);
STATIC_CHECK(offsetof(mien_register_options, sigma_start_mm) == 96, place_of_mien_register_options_sigma_start_mm);
STATIC_CHECK(offsetof(mien_register_options, sigma_end_mm) == 104, place_of_mien_register_options_sigma_end_mm);
STATIC_CHECK(offsetof(mien_register_options, max_angle_deg) == 112, place_of_mien_register_options_max_angle_deg);
STATIC_CHECK(offsetof(mien_register_options, start_rotation) == 120, place_of_mien_register_options_start_rotation);
STATIC_CHECK(offsetof(mien_register_options, start_translation) == 192, place_of_mien_register_options_start_translation);
STATIC_CHECK(offsetof(mien_register_options, start_scale) == 216, place_of_mien_register_options_start_scale);
STATIC_CHECK(offsetof(mien_register_options, progress) == 224, place_of_mien_register_options_progress);
STATIC_CHECK(offsetof(mien_register_options, progress_user) == 232, place_of_mien_register_options_progress_user);
STATIC_CHECK(offsetof(mien_register_options, cancel) == 240, place_of_mien_register_options_cancel);
STATIC_CHECK(offsetof(mien_register_options, color_features) == 248, place_of_mien_register_options_color_features);
STATIC_CHECK(offsetof(mien_register_options, reserved) == 252, place_of_mien_register_options_reserved);
STATIC_CHECK(offsetof(mien_register_options, unit_to_mm) == 256, place_of_mien_register_options_unit_to_mm);
STATIC_CHECK(offsetof(mien_register_options, landmark_sides) == 264, place_of_mien_register_options_landmark_sides);
STATIC_CHECK(offsetof(mien_register_options, reserved2) == 268, place_of_mien_register_options_reserved2);
STATIC_CHECK(offsetof(mien_register_options, max_distance_mm) == 272, place_of_mien_register_options_max_distance_mm);
STATIC_CHECK(offsetof(mien_register_options, mutual_mm) == 280, place_of_mien_register_options_mutual_mm);
STATIC_CHECK(offsetof(mien_register_options, soft_mm) == 288, place_of_mien_register_options_soft_mm);
STATIC_CHECK(sizeof(mien_fit_verdict) == 80, size_of_mien_fit_verdict);
STATIC_CHECK(offsetof(mien_fit_verdict, struct_size) == 0, place_of_mien_fit_verdict_struct_size);
STATIC_CHECK(offsetof(mien_fit_verdict, quality) == 4, place_of_mien_fit_verdict_quality);
STATIC_CHECK(offsetof(mien_fit_verdict, coverage) == 8, place_of_mien_fit_verdict_coverage);
STATIC_CHECK(offsetof(mien_fit_verdict, inlier_share) == 16, place_of_mien_fit_verdict_inlier_share);
STATIC_CHECK(offsetof(mien_fit_verdict, mean_residual_mm) == 24, place_of_mien_fit_verdict_mean_residual_mm);
STATIC_CHECK(offsetof(mien_fit_verdict, landmark_rms_mm) == 32, place_of_mien_fit_verdict_landmark_rms_mm);
STATIC_CHECK(offsetof(mien_fit_verdict, size_ratio) == 40, place_of_mien_fit_verdict_size_ratio);
STATIC_CHECK(offsetof(mien_fit_verdict, mean_deviation) == 48, place_of_mien_fit_verdict_mean_deviation);
STATIC_CHECK(offsetof(mien_fit_verdict, unit_to_mm) == 56, place_of_mien_fit_verdict_unit_to_mm);
STATIC_CHECK(offsetof(mien_fit_verdict, landmarks_used) == 64, place_of_mien_fit_verdict_landmarks_used);
STATIC_CHECK(offsetof(mien_fit_verdict, landmarks_rejected) == 68, place_of_mien_fit_verdict_landmarks_rejected);
STATIC_CHECK(offsetof(mien_fit_verdict, flipped_triangles) == 72, place_of_mien_fit_verdict_flipped_triangles);
STATIC_CHECK(offsetof(mien_fit_verdict, self_intersections) == 76, place_of_mien_fit_verdict_self_intersections);
STATIC_CHECK(sizeof(mien_expected_error) == 40, size_of_mien_expected_error);
STATIC_CHECK(offsetof(mien_expected_error, struct_size) == 0, place_of_mien_expected_error_struct_size);
STATIC_CHECK(offsetof(mien_expected_error, quality) == 4, place_of_mien_expected_error_quality);
STATIC_CHECK(offsetof(mien_expected_error, expected_mm) == 8, place_of_mien_expected_error_expected_mm);
STATIC_CHECK(offsetof(mien_expected_error, low_mm) == 16, place_of_mien_expected_error_low_mm);
STATIC_CHECK(offsetof(mien_expected_error, high_mm) == 24, place_of_mien_expected_error_high_mm);
STATIC_CHECK(offsetof(mien_expected_error, unseen) == 32, place_of_mien_expected_error_unseen);
STATIC_CHECK(sizeof(mien_tie_options) == 48, size_of_mien_tie_options);
STATIC_CHECK(offsetof(mien_tie_options, struct_size) == 0, place_of_mien_tie_options_struct_size);
STATIC_CHECK(offsetof(mien_tie_options, reserved) == 4, place_of_mien_tie_options_reserved);
STATIC_CHECK(offsetof(mien_tie_options, max_slide_mm) == 8, place_of_mien_tie_options_max_slide_mm);
STATIC_CHECK(offsetof(mien_tie_options, least_share) == 16, place_of_mien_tie_options_least_share);
STATIC_CHECK(offsetof(mien_tie_options, progress) == 24, place_of_mien_tie_options_progress);
STATIC_CHECK(offsetof(mien_tie_options, progress_user) == 32, place_of_mien_tie_options_progress_user);
STATIC_CHECK(offsetof(mien_tie_options, cancel) == 40, place_of_mien_tie_options_cancel);
STATIC_CHECK(sizeof(mien_batch_options) == 32, size_of_mien_batch_options);
STATIC_CHECK(offsetof(mien_batch_options, struct_size) == 0, place_of_mien_batch_options_struct_size);
STATIC_CHECK(offsetof(mien_batch_options, reserved) == 4, place_of_mien_batch_options_reserved);
STATIC_CHECK(offsetof(mien_batch_options, progress) == 8, place_of_mien_batch_options_progress);
STATIC_CHECK(offsetof(mien_batch_options, progress_user) == 16, place_of_mien_batch_options_progress_user);
STATIC_CHECK(offsetof(mien_batch_options, cancel) == 24, place_of_mien_batch_options_cancel);
STATIC_CHECK(sizeof(mien_spectral_basis_options) == 40, size_of_mien_spectral_basis_options);
STATIC_CHECK(offsetof(mien_spectral_basis_options, struct_size) == 0, place_of_mien_spectral_basis_options_struct_size);
STATIC_CHECK(offsetof(mien_spectral_basis_options, mode_count) == 4, place_of_mien_spectral_basis_options_mode_count);
STATIC_CHECK(offsetof(mien_spectral_basis_options, mass) == 8, place_of_mien_spectral_basis_options_mass);
STATIC_CHECK(offsetof(mien_spectral_basis_options, cotangents) == 12, place_of_mien_spectral_basis_options_cotangents);
STATIC_CHECK(offsetof(mien_spectral_basis_options, progress) == 16, place_of_mien_spectral_basis_options_progress);
STATIC_CHECK(offsetof(mien_spectral_basis_options, progress_user) == 24, place_of_mien_spectral_basis_options_progress_user);
STATIC_CHECK(offsetof(mien_spectral_basis_options, cancel) == 32, place_of_mien_spectral_basis_options_cancel);
STATIC_CHECK(sizeof(mien_blendshape_options) == 40, size_of_mien_blendshape_options);
STATIC_CHECK(offsetof(mien_blendshape_options, struct_size) == 0, place_of_mien_blendshape_options_struct_size);
STATIC_CHECK(offsetof(mien_blendshape_options, reserved) == 4, place_of_mien_blendshape_options_reserved);
STATIC_CHECK(offsetof(mien_blendshape_options, ridge) == 8, place_of_mien_blendshape_options_ridge);
STATIC_CHECK(offsetof(mien_blendshape_options, progress) == 16, place_of_mien_blendshape_options_progress);
STATIC_CHECK(offsetof(mien_blendshape_options, progress_user) == 24, place_of_mien_blendshape_options_progress_user);
STATIC_CHECK(offsetof(mien_blendshape_options, cancel) == 32, place_of_mien_blendshape_options_cancel);
STATIC_CHECK(sizeof(mien_band_choice) == 40, size_of_mien_band_choice);
STATIC_CHECK(offsetof(mien_band_choice, k) == 0, place_of_mien_band_choice_k);
STATIC_CHECK(offsetof(mien_band_choice, l1_mm) == 8, place_of_mien_band_choice_l1_mm);
STATIC_CHECK(offsetof(mien_band_choice, dame) == 16, place_of_mien_band_choice_dame);
STATIC_CHECK(offsetof(mien_band_choice, fmpd) == 24, place_of_mien_band_choice_fmpd);
STATIC_CHECK(offsetof(mien_band_choice, on_front) == 32, place_of_mien_band_choice_on_front);
STATIC_CHECK(offsetof(mien_band_choice, chosen) == 36, place_of_mien_band_choice_chosen);
STATIC_CHECK(sizeof(mien_neutralize_options) == 128, size_of_mien_neutralize_options);
STATIC_CHECK(offsetof(mien_neutralize_options, struct_size) == 0, place_of_mien_neutralize_options_struct_size);
STATIC_CHECK(offsetof(mien_neutralize_options, method) == 4, place_of_mien_neutralize_options_method);
STATIC_CHECK(offsetof(mien_neutralize_options, max_sweeps) == 8, place_of_mien_neutralize_options_max_sweeps);
STATIC_CHECK(offsetof(mien_neutralize_options, uncertainty) == 12, place_of_mien_neutralize_options_uncertainty);
STATIC_CHECK(offsetof(mien_neutralize_options, pose) == 16, place_of_mien_neutralize_options_pose);
STATIC_CHECK(offsetof(mien_neutralize_options, reserved) == 20, place_of_mien_neutralize_options_reserved);
STATIC_CHECK(offsetof(mien_neutralize_options, tolerance_mm) == 24, place_of_mien_neutralize_options_tolerance_mm);
STATIC_CHECK(offsetof(mien_neutralize_options, noise_mm2) == 32, place_of_mien_neutralize_options_noise_mm2);
STATIC_CHECK(offsetof(mien_neutralize_options, decay_mm) == 40, place_of_mien_neutralize_options_decay_mm);
STATIC_CHECK(offsetof(mien_neutralize_options, weights) == 48, place_of_mien_neutralize_options_weights);
STATIC_CHECK(offsetof(mien_neutralize_options, progress) == 80, place_of_mien_neutralize_options_progress);
STATIC_CHECK(offsetof(mien_neutralize_options, progress_user) == 88, place_of_mien_neutralize_options_progress_user);
STATIC_CHECK(offsetof(mien_neutralize_options, cancel) == 96, place_of_mien_neutralize_options_cancel);
STATIC_CHECK(offsetof(mien_neutralize_options, treated) == 104, place_of_mien_neutralize_options_treated);
STATIC_CHECK(offsetof(mien_neutralize_options, treated_count) == 112, place_of_mien_neutralize_options_treated_count);
STATIC_CHECK(offsetof(mien_neutralize_options, treated_margin_mm) == 120, place_of_mien_neutralize_options_treated_margin_mm);
STATIC_CHECK(sizeof(mien_zone_reading) == 32, size_of_mien_zone_reading);
STATIC_CHECK(offsetof(mien_zone_reading, struct_size) == 0, place_of_mien_zone_reading_struct_size);
STATIC_CHECK(offsetof(mien_zone_reading, differ) == 4, place_of_mien_zone_reading_differ);
STATIC_CHECK(offsetof(mien_zone_reading, probability) == 8, place_of_mien_zone_reading_probability);
STATIC_CHECK(offsetof(mien_zone_reading, removed_mm) == 16, place_of_mien_zone_reading_removed_mm);
STATIC_CHECK(offsetof(mien_zone_reading, removed_ml) == 24, place_of_mien_zone_reading_removed_ml);
STATIC_CHECK(sizeof(mien_evaluate_options) == 104, size_of_mien_evaluate_options);
STATIC_CHECK(offsetof(mien_evaluate_options, struct_size) == 0, place_of_mien_evaluate_options_struct_size);
STATIC_CHECK(offsetof(mien_evaluate_options, method) == 4, place_of_mien_evaluate_options_method);
STATIC_CHECK(offsetof(mien_evaluate_options, max_sweeps) == 8, place_of_mien_evaluate_options_max_sweeps);
STATIC_CHECK(offsetof(mien_evaluate_options, against_method) == 12, place_of_mien_evaluate_options_against_method);
STATIC_CHECK(offsetof(mien_evaluate_options, against_max_sweeps) == 16, place_of_mien_evaluate_options_against_max_sweeps);
STATIC_CHECK(offsetof(mien_evaluate_options, reserved) == 20, place_of_mien_evaluate_options_reserved);
STATIC_CHECK(offsetof(mien_evaluate_options, against) == 24, place_of_mien_evaluate_options_against);
STATIC_CHECK(offsetof(mien_evaluate_options, zone_vertices) == 32, place_of_mien_evaluate_options_zone_vertices);
STATIC_CHECK(offsetof(mien_evaluate_options, zone_count) == 40, place_of_mien_evaluate_options_zone_count);
STATIC_CHECK(offsetof(mien_evaluate_options, stable_vertices) == 48, place_of_mien_evaluate_options_stable_vertices);
STATIC_CHECK(offsetof(mien_evaluate_options, stable_count) == 56, place_of_mien_evaluate_options_stable_count);
STATIC_CHECK(offsetof(mien_evaluate_options, progress) == 64, place_of_mien_evaluate_options_progress);
STATIC_CHECK(offsetof(mien_evaluate_options, progress_user) == 72, place_of_mien_evaluate_options_progress_user);
STATIC_CHECK(offsetof(mien_evaluate_options, cancel) == 80, place_of_mien_evaluate_options_cancel);
STATIC_CHECK(offsetof(mien_evaluate_options, volume_zones) == 88, place_of_mien_evaluate_options_volume_zones);
STATIC_CHECK(offsetof(mien_evaluate_options, volume_zone_count) == 96, place_of_mien_evaluate_options_volume_zone_count);
STATIC_CHECK(sizeof(mien_follow_options) == 96, size_of_mien_follow_options);
STATIC_CHECK(offsetof(mien_follow_options, struct_size) == 0, place_of_mien_follow_options_struct_size);
STATIC_CHECK(offsetof(mien_follow_options, rounds) == 4, place_of_mien_follow_options_rounds);
STATIC_CHECK(offsetof(mien_follow_options, max_vertices) == 8, place_of_mien_follow_options_max_vertices);
STATIC_CHECK(offsetof(mien_follow_options, max_scalar_modes) == 12, place_of_mien_follow_options_max_scalar_modes);
STATIC_CHECK(offsetof(mien_follow_options, max_pca_modes) == 16, place_of_mien_follow_options_max_pca_modes);
STATIC_CHECK(offsetof(mien_follow_options, reserved) == 20, place_of_mien_follow_options_reserved);
STATIC_CHECK(offsetof(mien_follow_options, temporal_mm) == 24, place_of_mien_follow_options_temporal_mm);
STATIC_CHECK(offsetof(mien_follow_options, sigma_start_mm) == 32, place_of_mien_follow_options_sigma_start_mm);
STATIC_CHECK(offsetof(mien_follow_options, sigma_end_mm) == 40, place_of_mien_follow_options_sigma_end_mm);
STATIC_CHECK(offsetof(mien_follow_options, lost_share) == 48, place_of_mien_follow_options_lost_share);
STATIC_CHECK(offsetof(mien_follow_options, unit_to_mm) == 56, place_of_mien_follow_options_unit_to_mm);
STATIC_CHECK(offsetof(mien_follow_options, focal_x) == 64, place_of_mien_follow_options_focal_x);
STATIC_CHECK(offsetof(mien_follow_options, focal_y) == 72, place_of_mien_follow_options_focal_y);
STATIC_CHECK(offsetof(mien_follow_options, centre_x) == 80, place_of_mien_follow_options_centre_x);
STATIC_CHECK(offsetof(mien_follow_options, centre_y) == 88, place_of_mien_follow_options_centre_y);
STATIC_CHECK(sizeof(mien_follow_state) == 32, size_of_mien_follow_state);
STATIC_CHECK(offsetof(mien_follow_state, struct_size) == 0, place_of_mien_follow_state_struct_size);
STATIC_CHECK(offsetof(mien_follow_state, state) == 4, place_of_mien_follow_state_state);
STATIC_CHECK(offsetof(mien_follow_state, share) == 8, place_of_mien_follow_state_share);
STATIC_CHECK(offsetof(mien_follow_state, residual_mm) == 16, place_of_mien_follow_state_residual_mm);
STATIC_CHECK(offsetof(mien_follow_state, slide_mm) == 24, place_of_mien_follow_state_slide_mm);
STATIC_CHECK(sizeof(mien_geodesic_options) == 40, size_of_mien_geodesic_options);
STATIC_CHECK(offsetof(mien_geodesic_options, struct_size) == 0, place_of_mien_geodesic_options_struct_size);
STATIC_CHECK(offsetof(mien_geodesic_options, heat_boundary) == 4, place_of_mien_geodesic_options_heat_boundary);
STATIC_CHECK(offsetof(mien_geodesic_options, heat_time_factor) == 8, place_of_mien_geodesic_options_heat_time_factor);
STATIC_CHECK(offsetof(mien_geodesic_options, progress) == 16, place_of_mien_geodesic_options_progress);
STATIC_CHECK(offsetof(mien_geodesic_options, progress_user) == 24, place_of_mien_geodesic_options_progress_user);
STATIC_CHECK(offsetof(mien_geodesic_options, cancel) == 32, place_of_mien_geodesic_options_cancel);
STATIC_CHECK(sizeof(mien_model_fit_options) == 56, size_of_mien_model_fit_options);
STATIC_CHECK(offsetof(mien_model_fit_options, struct_size) == 0, place_of_mien_model_fit_options_struct_size);
STATIC_CHECK(offsetof(mien_model_fit_options, align) == 4, place_of_mien_model_fit_options_align);
STATIC_CHECK(offsetof(mien_model_fit_options, ridge_mm2) == 8, place_of_mien_model_fit_options_ridge_mm2);
STATIC_CHECK(offsetof(mien_model_fit_options, weights) == 16, place_of_mien_model_fit_options_weights);
STATIC_CHECK(offsetof(mien_model_fit_options, scalar_modes) == 48, place_of_mien_model_fit_options_scalar_modes);
STATIC_CHECK(offsetof(mien_model_fit_options, vector_modes) == 52, place_of_mien_model_fit_options_vector_modes);
STATIC_CHECK(sizeof(mien_network_options) == 24, size_of_mien_network_options);
STATIC_CHECK(offsetof(mien_network_options, struct_size) == 0, place_of_mien_network_options_struct_size);
STATIC_CHECK(offsetof(mien_network_options, reserved) == 4, place_of_mien_network_options_reserved);
STATIC_CHECK(offsetof(mien_network_options, cancel) == 8, place_of_mien_network_options_cancel);
STATIC_CHECK(offsetof(mien_network_options, band_limit) == 16, place_of_mien_network_options_band_limit);
STATIC_CHECK(sizeof(mien_network_evaluation_options) == 56, size_of_mien_network_evaluation_options);
STATIC_CHECK(offsetof(mien_network_evaluation_options, struct_size) == 0, place_of_mien_network_evaluation_options_struct_size);
STATIC_CHECK(offsetof(mien_network_evaluation_options, neutral_only) == 4, place_of_mien_network_evaluation_options_neutral_only);
STATIC_CHECK(offsetof(mien_network_evaluation_options, perceptual) == 8, place_of_mien_network_evaluation_options_perceptual);
STATIC_CHECK(offsetof(mien_network_evaluation_options, reserved) == 12, place_of_mien_network_evaluation_options_reserved);
STATIC_CHECK(offsetof(mien_network_evaluation_options, subjects) == 16, place_of_mien_network_evaluation_options_subjects);
STATIC_CHECK(offsetof(mien_network_evaluation_options, subject_count) == 24, place_of_mien_network_evaluation_options_subject_count);
STATIC_CHECK(offsetof(mien_network_evaluation_options, progress) == 32, place_of_mien_network_evaluation_options_progress);
STATIC_CHECK(offsetof(mien_network_evaluation_options, progress_user) == 40, place_of_mien_network_evaluation_options_progress_user);
STATIC_CHECK(offsetof(mien_network_evaluation_options, cancel) == 48, place_of_mien_network_evaluation_options_cancel);
STATIC_CHECK(sizeof(mien_representation_options) == 32, size_of_mien_representation_options);
STATIC_CHECK(offsetof(mien_representation_options, struct_size) == 0, place_of_mien_representation_options_struct_size);
STATIC_CHECK(offsetof(mien_representation_options, neutral_only) == 4, place_of_mien_representation_options_neutral_only);
STATIC_CHECK(offsetof(mien_representation_options, progress) == 8, place_of_mien_representation_options_progress);
STATIC_CHECK(offsetof(mien_representation_options, progress_user) == 16, place_of_mien_representation_options_progress_user);
STATIC_CHECK(offsetof(mien_representation_options, cancel) == 24, place_of_mien_representation_options_cancel);
STATIC_CHECK(sizeof(mien_score_options) == 136, size_of_mien_score_options);
STATIC_CHECK(offsetof(mien_score_options, struct_size) == 0, place_of_mien_score_options_struct_size);
STATIC_CHECK(offsetof(mien_score_options, method) == 4, place_of_mien_score_options_method);
STATIC_CHECK(offsetof(mien_score_options, num_components) == 8, place_of_mien_score_options_num_components);
STATIC_CHECK(offsetof(mien_score_options, max_components) == 12, place_of_mien_score_options_max_components);
STATIC_CHECK(offsetof(mien_score_options, folds) == 16, place_of_mien_score_options_folds);
STATIC_CHECK(offsetof(mien_score_options, reserved) == 20, place_of_mien_score_options_reserved);
STATIC_CHECK(offsetof(mien_score_options, seed) == 24, place_of_mien_score_options_seed);
STATIC_CHECK(offsetof(mien_score_options, curvature_share) == 32, place_of_mien_score_options_curvature_share);
STATIC_CHECK(offsetof(mien_score_options, curvature_radius_mm) == 40, place_of_mien_score_options_curvature_radius_mm);
STATIC_CHECK(offsetof(mien_score_options, lowest) == 48, place_of_mien_score_options_lowest);
STATIC_CHECK(offsetof(mien_score_options, highest) == 56, place_of_mien_score_options_highest);
STATIC_CHECK(offsetof(mien_score_options, zone_vertices) == 64, place_of_mien_score_options_zone_vertices);
STATIC_CHECK(offsetof(mien_score_options, zone_count) == 72, place_of_mien_score_options_zone_count);
STATIC_CHECK(offsetof(mien_score_options, stable_vertices) == 80, place_of_mien_score_options_stable_vertices);
STATIC_CHECK(offsetof(mien_score_options, stable_count) == 88, place_of_mien_score_options_stable_count);
STATIC_CHECK(offsetof(mien_score_options, progress) == 96, place_of_mien_score_options_progress);
STATIC_CHECK(offsetof(mien_score_options, progress_user) == 104, place_of_mien_score_options_progress_user);
STATIC_CHECK(offsetof(mien_score_options, cancel) == 112, place_of_mien_score_options_cancel);
STATIC_CHECK(offsetof(mien_score_options, focus) == 120, place_of_mien_score_options_focus);
STATIC_CHECK(offsetof(mien_score_options, reserved2) == 124, place_of_mien_score_options_reserved2);
STATIC_CHECK(offsetof(mien_score_options, features) == 128, place_of_mien_score_options_features);
STATIC_CHECK(offsetof(mien_score_options, reserved3) == 132, place_of_mien_score_options_reserved3);
STATIC_CHECK(sizeof(mien_score_prediction) == 40, size_of_mien_score_prediction);
STATIC_CHECK(offsetof(mien_score_prediction, struct_size) == 0, place_of_mien_score_prediction_struct_size);
STATIC_CHECK(offsetof(mien_score_prediction, extrapolates) == 4, place_of_mien_score_prediction_extrapolates);
STATIC_CHECK(offsetof(mien_score_prediction, score) == 8, place_of_mien_score_prediction_score);
STATIC_CHECK(offsetof(mien_score_prediction, low95) == 16, place_of_mien_score_prediction_low95);
STATIC_CHECK(offsetof(mien_score_prediction, high95) == 24, place_of_mien_score_prediction_high95);
STATIC_CHECK(offsetof(mien_score_prediction, leverage) == 32, place_of_mien_score_prediction_leverage);
STATIC_CHECK(sizeof(mien_series_options) == 112, size_of_mien_series_options);
STATIC_CHECK(offsetof(mien_series_options, struct_size) == 0, place_of_mien_series_options_struct_size);
STATIC_CHECK(offsetof(mien_series_options, method) == 4, place_of_mien_series_options_method);
STATIC_CHECK(offsetof(mien_series_options, pose) == 8, place_of_mien_series_options_pose);
STATIC_CHECK(offsetof(mien_series_options, reserved) == 12, place_of_mien_series_options_reserved);
STATIC_CHECK(offsetof(mien_series_options, scan_noise_share) == 16, place_of_mien_series_options_scan_noise_share);
STATIC_CHECK(offsetof(mien_series_options, noise_mm2) == 24, place_of_mien_series_options_noise_mm2);
STATIC_CHECK(offsetof(mien_series_options, changing_vertices) == 32, place_of_mien_series_options_changing_vertices);
STATIC_CHECK(offsetof(mien_series_options, changing_count) == 40, place_of_mien_series_options_changing_count);
STATIC_CHECK(offsetof(mien_series_options, expected_change_mm) == 48, place_of_mien_series_options_expected_change_mm);
STATIC_CHECK(offsetof(mien_series_options, progress) == 56, place_of_mien_series_options_progress);
STATIC_CHECK(offsetof(mien_series_options, progress_user) == 64, place_of_mien_series_options_progress_user);
STATIC_CHECK(offsetof(mien_series_options, cancel) == 72, place_of_mien_series_options_cancel);
STATIC_CHECK(offsetof(mien_series_options, weights) == 80, place_of_mien_series_options_weights);
STATIC_CHECK(sizeof(mien_study_options) == 160, size_of_mien_study_options);
STATIC_CHECK(offsetof(mien_study_options, struct_size) == 0, place_of_mien_study_options_struct_size);
STATIC_CHECK(offsetof(mien_study_options, reserved) == 4, place_of_mien_study_options_reserved);
STATIC_CHECK(offsetof(mien_study_options, zones) == 8, place_of_mien_study_options_zones);
STATIC_CHECK(offsetof(mien_study_options, zone_count) == 16, place_of_mien_study_options_zone_count);
STATIC_CHECK(offsetof(mien_study_options, treated_zones) == 24, place_of_mien_study_options_treated_zones);
STATIC_CHECK(offsetof(mien_study_options, treated_count) == 32, place_of_mien_study_options_treated_count);
STATIC_CHECK(offsetof(mien_study_options, stable_zones) == 40, place_of_mien_study_options_stable_zones);
STATIC_CHECK(offsetof(mien_study_options, stable_count) == 48, place_of_mien_study_options_stable_count);
STATIC_CHECK(offsetof(mien_study_options, visits) == 56, place_of_mien_study_options_visits);
STATIC_CHECK(offsetof(mien_study_options, visit_number_count) == 64, place_of_mien_study_options_visit_number_count);
STATIC_CHECK(offsetof(mien_study_options, margin_mm) == 72, place_of_mien_study_options_margin_mm);
STATIC_CHECK(offsetof(mien_study_options, level) == 80, place_of_mien_study_options_level);
STATIC_CHECK(offsetof(mien_study_options, noise_mm) == 88, place_of_mien_study_options_noise_mm);
STATIC_CHECK(offsetof(mien_study_options, correlation_length_mm) == 96, place_of_mien_study_options_correlation_length_mm);
STATIC_CHECK(offsetof(mien_study_options, common_bias_mm) == 104, place_of_mien_study_options_common_bias_mm);
STATIC_CHECK(offsetof(mien_study_options, untrained_share) == 112, place_of_mien_study_options_untrained_share);
STATIC_CHECK(offsetof(mien_study_options, min_seen_share) == 120, place_of_mien_study_options_min_seen_share);
STATIC_CHECK(offsetof(mien_study_options, progress) == 128, place_of_mien_study_options_progress);
STATIC_CHECK(offsetof(mien_study_options, progress_user) == 136, place_of_mien_study_options_progress_user);
STATIC_CHECK(offsetof(mien_study_options, cancel) == 144, place_of_mien_study_options_cancel);
STATIC_CHECK(offsetof(mien_study_options, measure_unseen) == 152, place_of_mien_study_options_measure_unseen);
STATIC_CHECK(offsetof(mien_study_options, reserved_end) == 156, place_of_mien_study_options_reserved_end);
STATIC_CHECK(sizeof(mien_study_value) == 40, size_of_mien_study_value);
STATIC_CHECK(offsetof(mien_study_value, value) == 0, place_of_mien_study_value_value);
STATIC_CHECK(offsetof(mien_study_value, sd) == 8, place_of_mien_study_value_sd);
STATIC_CHECK(offsetof(mien_study_value, low) == 16, place_of_mien_study_value_low);
STATIC_CHECK(offsetof(mien_study_value, high) == 24, place_of_mien_study_value_high);
STATIC_CHECK(offsetof(mien_study_value, limit_of_detection) == 32, place_of_mien_study_value_limit_of_detection);
STATIC_CHECK(sizeof(mien_study_change) == 320, size_of_mien_study_change);
STATIC_CHECK(offsetof(mien_study_change, struct_size) == 0, place_of_mien_study_change_struct_size);
STATIC_CHECK(offsetof(mien_study_change, unknown) == 4, place_of_mien_study_change_unknown);
STATIC_CHECK(offsetof(mien_study_change, signed_ml) == 8, place_of_mien_study_change_signed_ml);
STATIC_CHECK(offsetof(mien_study_change, gained_ml) == 48, place_of_mien_study_change_gained_ml);
STATIC_CHECK(offsetof(mien_study_change, lost_ml) == 88, place_of_mien_study_change_lost_ml);
STATIC_CHECK(offsetof(mien_study_change, absolute_ml) == 128, place_of_mien_study_change_absolute_ml);
STATIC_CHECK(offsetof(mien_study_change, area_change_mm2) == 168, place_of_mien_study_change_area_change_mm2);
STATIC_CHECK(offsetof(mien_study_change, mean_distance_mm) == 208, place_of_mien_study_change_mean_distance_mm);
STATIC_CHECK(offsetof(mien_study_change, surface_sd_ml) == 248, place_of_mien_study_change_surface_sd_ml);
STATIC_CHECK(offsetof(mien_study_change, alignment_sd_ml) == 256, place_of_mien_study_change_alignment_sd_ml);
STATIC_CHECK(offsetof(mien_study_change, bias_sd_ml) == 264, place_of_mien_study_change_bias_sd_ml);
STATIC_CHECK(offsetof(mien_study_change, expression_sd_ml) == 272, place_of_mien_study_change_expression_sd_ml);
STATIC_CHECK(offsetof(mien_study_change, expression_removed_ml) == 280, place_of_mien_study_change_expression_removed_ml);
STATIC_CHECK(offsetof(mien_study_change, seen_share) == 288, place_of_mien_study_change_seen_share);
STATIC_CHECK(offsetof(mien_study_change, area_before_mm2) == 296, place_of_mien_study_change_area_before_mm2);
STATIC_CHECK(offsetof(mien_study_change, area_after_mm2) == 304, place_of_mien_study_change_area_after_mm2);
STATIC_CHECK(offsetof(mien_study_change, detected) == 312, place_of_mien_study_change_detected);
STATIC_CHECK(offsetof(mien_study_change, reserved) == 316, place_of_mien_study_change_reserved);
STATIC_CHECK(sizeof(mien_train_options) == 96, size_of_mien_train_options);
STATIC_CHECK(offsetof(mien_train_options, struct_size) == 0, place_of_mien_train_options_struct_size);
STATIC_CHECK(offsetof(mien_train_options, method) == 4, place_of_mien_train_options_method);
STATIC_CHECK(offsetof(mien_train_options, identity_modes) == 8, place_of_mien_train_options_identity_modes);
STATIC_CHECK(offsetof(mien_train_options, expression_modes) == 12, place_of_mien_train_options_expression_modes);
STATIC_CHECK(offsetof(mien_train_options, max_iterations) == 16, place_of_mien_train_options_max_iterations);
STATIC_CHECK(offsetof(mien_train_options, passes) == 20, place_of_mien_train_options_passes);
STATIC_CHECK(offsetof(mien_train_options, lambda) == 24, place_of_mien_train_options_lambda);
STATIC_CHECK(offsetof(mien_train_options, lambda_factor) == 32, place_of_mien_train_options_lambda_factor);
STATIC_CHECK(offsetof(mien_train_options, angle_tolerance_rad) == 40, place_of_mien_train_options_angle_tolerance_rad);
STATIC_CHECK(offsetof(mien_train_options, noise_mm2) == 48, place_of_mien_train_options_noise_mm2);
STATIC_CHECK(offsetof(mien_train_options, stable_vertices) == 56, place_of_mien_train_options_stable_vertices);
STATIC_CHECK(offsetof(mien_train_options, stable_count) == 64, place_of_mien_train_options_stable_count);
STATIC_CHECK(offsetof(mien_train_options, progress) == 72, place_of_mien_train_options_progress);
STATIC_CHECK(offsetof(mien_train_options, progress_user) == 80, place_of_mien_train_options_progress_user);
STATIC_CHECK(offsetof(mien_train_options, cancel) == 88, place_of_mien_train_options_cancel);
STATIC_CHECK(sizeof(mien_shard_options) == 56, size_of_mien_shard_options);
STATIC_CHECK(offsetof(mien_shard_options, struct_size) == 0, place_of_mien_shard_options_struct_size);
STATIC_CHECK(offsetof(mien_shard_options, part) == 4, place_of_mien_shard_options_part);
STATIC_CHECK(offsetof(mien_shard_options, part_count) == 8, place_of_mien_shard_options_part_count);
STATIC_CHECK(offsetof(mien_shard_options, max_rank) == 12, place_of_mien_shard_options_max_rank);
STATIC_CHECK(offsetof(mien_shard_options, progress) == 16, place_of_mien_shard_options_progress);
STATIC_CHECK(offsetof(mien_shard_options, progress_user) == 24, place_of_mien_shard_options_progress_user);
STATIC_CHECK(offsetof(mien_shard_options, cancel) == 32, place_of_mien_shard_options_cancel);
STATIC_CHECK(offsetof(mien_shard_options, stable_vertices) == 40, place_of_mien_shard_options_stable_vertices);
STATIC_CHECK(offsetof(mien_shard_options, stable_count) == 48, place_of_mien_shard_options_stable_count);
STATIC_CHECK(sizeof(mien_visits_options) == 96, size_of_mien_visits_options);
STATIC_CHECK(offsetof(mien_visits_options, struct_size) == 0, place_of_mien_visits_options_struct_size);
STATIC_CHECK(offsetof(mien_visits_options, pose) == 4, place_of_mien_visits_options_pose);
STATIC_CHECK(offsetof(mien_visits_options, normal_noise_mm2) == 8, place_of_mien_visits_options_normal_noise_mm2);
STATIC_CHECK(offsetof(mien_visits_options, tangential_noise_mm2) == 16, place_of_mien_visits_options_tangential_noise_mm2);
STATIC_CHECK(offsetof(mien_visits_options, treated_vertices) == 24, place_of_mien_visits_options_treated_vertices);
STATIC_CHECK(offsetof(mien_visits_options, treated_count) == 32, place_of_mien_visits_options_treated_count);
STATIC_CHECK(offsetof(mien_visits_options, weights) == 40, place_of_mien_visits_options_weights);
STATIC_CHECK(offsetof(mien_visits_options, progress) == 72, place_of_mien_visits_options_progress);
STATIC_CHECK(offsetof(mien_visits_options, progress_user) == 80, place_of_mien_visits_options_progress_user);
STATIC_CHECK(offsetof(mien_visits_options, cancel) == 88, place_of_mien_visits_options_cancel);

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1status_1name(JNIEnv *env, jobject self, jint status) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_status_name((mien_status)status);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1version_1number(JNIEnv *env, jobject self) {
    (void)env;
    (void)self;
    return (jint)mien_version_number();
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1version_1string(JNIEnv *env, jobject self) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_version_string();
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1build_1id(JNIEnv *env, jobject self) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_build_id();
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1session_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_session_options_init((mien_session_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1session_1create(JNIEnv *env, jobject self, jint abi_version, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_session_create((uint32_t)abi_version, (mien_session**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1session_1create_1with_1options(JNIEnv *env, jobject self, jint abi_version, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_session_create_with_options((uint32_t)abi_version, (const mien_session_options*)(intptr_t)options, (mien_session**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1session_1release(JNIEnv *env, jobject self, jlong session) {
    (void)env;
    (void)self;
    mien_session_release((mien_session*)(intptr_t)session);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1cancel_1create(JNIEnv *env, jobject self, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_cancel_create((mien_cancel**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1cancel_1request(JNIEnv *env, jobject self, jlong cancel) {
    (void)env;
    (void)self;
    mien_cancel_request((mien_cancel*)(intptr_t)cancel);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1cancel_1release(JNIEnv *env, jobject self, jlong cancel) {
    (void)env;
    (void)self;
    mien_cancel_release((mien_cancel*)(intptr_t)cancel);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1session_1hash_1file(JNIEnv *env, jobject self, jlong session, jlong path, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_session_hash_file((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1mesh_1arrays_1init(JNIEnv *env, jobject self, jlong arrays, jlong struct_size) {
    (void)env;
    (void)self;
    mien_mesh_arrays_init((mien_mesh_arrays*)(intptr_t)arrays, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1create(JNIEnv *env, jobject self, jlong session, jlong arrays, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_create((mien_session*)(intptr_t)session, (const mien_mesh_arrays*)(intptr_t)arrays, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1save(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_save((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1counts(JNIEnv *env, jobject self, jlong mesh, jlong vertex_count, jlong triangle_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_counts((const mien_mesh*)(intptr_t)mesh, (uint64_t*)(intptr_t)vertex_count, (uint64_t*)(intptr_t)triangle_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1positions(JNIEnv *env, jobject self, jlong mesh, jint dtype, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_positions((const mien_mesh*)(intptr_t)mesh, (mien_dtype)dtype, (void*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1triangles(JNIEnv *env, jobject self, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_triangles((const mien_mesh*)(intptr_t)mesh, (uint32_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1colors(JNIEnv *env, jobject self, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_colors((const mien_mesh*)(intptr_t)mesh, (uint8_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1format_1count(JNIEnv *env, jobject self) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_format_count();
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1mesh_1format_1extension(JNIEnv *env, jobject self, jint format) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_mesh_format_extension((uint32_t)format);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1mesh_1format_1description(JNIEnv *env, jobject self, jint format) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_mesh_format_description((uint32_t)format);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1format_1writes(JNIEnv *env, jobject self, jint format) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_format_writes((uint32_t)format);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1texture(JNIEnv *env, jobject self, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_texture((const mien_mesh*)(intptr_t)mesh, (float*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1texture_1triangles(JNIEnv *env, jobject self, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_texture_triangles((const mien_mesh*)(intptr_t)mesh, (uint32_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1triangle_1materials(JNIEnv *env, jobject self, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_triangle_materials((const mien_mesh*)(intptr_t)mesh, (uint32_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1material_1counts(JNIEnv *env, jobject self, jlong mesh, jlong material_count, jlong image_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_material_counts((const mien_mesh*)(intptr_t)mesh, (uint64_t*)(intptr_t)material_count, (uint64_t*)(intptr_t)image_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1material(JNIEnv *env, jobject self, jlong mesh, jlong material, jlong image, jlong red, jlong green, jlong blue, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_material((const mien_mesh*)(intptr_t)mesh, (uint64_t)material, (int32_t*)(intptr_t)image, (double*)(intptr_t)red, (double*)(intptr_t)green, (double*)(intptr_t)blue, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1material_1name(JNIEnv *env, jobject self, jlong mesh, jlong material, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_material_name((const mien_mesh*)(intptr_t)mesh, (uint64_t)material, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1image_1name(JNIEnv *env, jobject self, jlong mesh, jlong image, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_image_name((const mien_mesh*)(intptr_t)mesh, (uint64_t)image, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1image_1file(JNIEnv *env, jobject self, jlong mesh, jlong image, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_image_file((const mien_mesh*)(intptr_t)mesh, (uint64_t)image, (uint8_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1image_1size(JNIEnv *env, jobject self, jlong mesh, jlong image, jlong width, jlong height, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_image_size((const mien_mesh*)(intptr_t)mesh, (uint64_t)image, (uint32_t*)(intptr_t)width, (uint32_t*)(intptr_t)height, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1get_1image_1pixels(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong image, jlong row_stride_bytes, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_get_image_pixels((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (uint64_t)image, (uint64_t)row_stride_bytes, (uint8_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1save_1targets(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong targets, jlong names, jlong target_count, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_save_targets((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const mien_mesh* const*)(intptr_t)targets, (const char* const*)(intptr_t)names, (uint64_t)target_count, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1load_1target(JNIEnv *env, jobject self, jlong session, jlong path, jlong name, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_load_target((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (const char*)(intptr_t)name, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1positions_1view(JNIEnv *env, jobject self, jlong mesh, jlong data, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_positions_view((const mien_mesh*)(intptr_t)mesh, (const double**)(intptr_t)data, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1mesh_1retain(JNIEnv *env, jobject self, jlong mesh) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_mesh_retain((const mien_mesh*)(intptr_t)mesh);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1mesh_1release(JNIEnv *env, jobject self, jlong mesh) {
    (void)env;
    (void)self;
    mien_mesh_release((mien_mesh*)(intptr_t)mesh);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1model_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_model_options_init((mien_model_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1build(JNIEnv *env, jobject self, jlong session, jlong template_mesh, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_build((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)template_mesh, (const mien_model_options*)(intptr_t)options, (mien_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1load_1memory(JNIEnv *env, jobject self, jlong session, jlong data, jlong size, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_load_memory((mien_session*)(intptr_t)session, (const void*)(intptr_t)data, (uint64_t)size, (mien_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1load_1trusted(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_load_trusted((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1save(JNIEnv *env, jobject self, jlong session, jlong model, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_save((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1get_1counts(JNIEnv *env, jobject self, jlong model, jlong vertex_count, jlong scalar_modes, jlong vector_modes, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_get_counts((const mien_model*)(intptr_t)model, (uint64_t*)(intptr_t)vertex_count, (uint64_t*)(intptr_t)scalar_modes, (uint64_t*)(intptr_t)vector_modes, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1get_1json(JNIEnv *env, jobject self, jlong model, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_get_json((const mien_model*)(intptr_t)model, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1get_1variance(JNIEnv *env, jobject self, jlong model, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_get_variance((const mien_model*)(intptr_t)model, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1sample(JNIEnv *env, jobject self, jlong session, jlong model, jlong seed, jlong index, jdouble strength, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_sample((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (uint64_t)seed, (uint64_t)index, (double)strength, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1condition(JNIEnv *env, jobject self, jlong session, jlong model, jlong observations, jlong observation_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_condition((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_landmark_observation*)(intptr_t)observations, (uint64_t)observation_count, (mien_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1tune_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_tune_options_init((mien_tune_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1tune(JNIEnv *env, jobject self, jlong session, jlong template_mesh, jlong dataset, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_tune((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)template_mesh, (const char*)(intptr_t)dataset, (const mien_tune_options*)(intptr_t)options, (mien_tuning**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1tuning_1get_1json(JNIEnv *env, jobject self, jlong tuning, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_tuning_get_json((const mien_tuning*)(intptr_t)tuning, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1tuning_1release(JNIEnv *env, jobject self, jlong tuning) {
    (void)env;
    (void)self;
    mien_tuning_release((mien_tuning*)(intptr_t)tuning);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1model_1mesh(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_model_mesh((const mien_model*)(intptr_t)model);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1model_1retain(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_model_retain((mien_model*)(intptr_t)model);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1model_1release(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_model_release((mien_model*)(intptr_t)model);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1create(JNIEnv *env, jobject self, jlong landmarks, jlong landmark_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_create((const mien_scan_landmark*)(intptr_t)landmarks, (uint64_t)landmark_count, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1get_1landmarks(JNIEnv *env, jobject self, jlong model, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_get_landmarks((const mien_model*)(intptr_t)model, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1match(JNIEnv *env, jobject self, jlong landmarks, jlong model, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_match((const mien_landmarks*)(intptr_t)landmarks, (const mien_model*)(intptr_t)model, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1on_1mesh(JNIEnv *env, jobject self, jlong landmarks, jlong mesh, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_on_mesh((const mien_landmarks*)(intptr_t)landmarks, (const mien_mesh*)(intptr_t)mesh, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1save(JNIEnv *env, jobject self, jlong session, jlong landmarks, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_save((mien_session*)(intptr_t)session, (const mien_landmarks*)(intptr_t)landmarks, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1get_1counts(JNIEnv *env, jobject self, jlong landmarks, jlong count, jlong picked_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_get_counts((const mien_landmarks*)(intptr_t)landmarks, (uint64_t*)(intptr_t)count, (uint64_t*)(intptr_t)picked_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1get_1name(JNIEnv *env, jobject self, jlong landmarks, jlong index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_get_name((const mien_landmarks*)(intptr_t)landmarks, (uint64_t)index, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1get_1mark(JNIEnv *env, jobject self, jlong landmarks, jlong index, jlong where, jlong position, jlong vertex, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_get_mark((const mien_landmarks*)(intptr_t)landmarks, (uint64_t)index, (int32_t*)(intptr_t)where, (double*)(intptr_t)position, (uint32_t*)(intptr_t)vertex, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1get_1json(JNIEnv *env, jobject self, jlong landmarks, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_get_json((const mien_landmarks*)(intptr_t)landmarks, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1landmarks_1retain(JNIEnv *env, jobject self, jlong landmarks) {
    (void)env;
    (void)self;
    mien_landmarks_retain((mien_landmarks*)(intptr_t)landmarks);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1landmarks_1release(JNIEnv *env, jobject self, jlong landmarks) {
    (void)env;
    (void)self;
    mien_landmarks_release((mien_landmarks*)(intptr_t)landmarks);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_zones**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1create(JNIEnv *env, jobject self, jlong zones, jlong zone_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_create((const mien_zone*)(intptr_t)zones, (uint64_t)zone_count, (mien_zones**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1get_1zones(JNIEnv *env, jobject self, jlong model, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_get_zones((const mien_model*)(intptr_t)model, (mien_zones**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1save(JNIEnv *env, jobject self, jlong session, jlong zones, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_save((mien_session*)(intptr_t)session, (const mien_zones*)(intptr_t)zones, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1get_1count(JNIEnv *env, jobject self, jlong zones, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_get_count((const mien_zones*)(intptr_t)zones, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1get_1name(JNIEnv *env, jobject self, jlong zones, jlong index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_get_name((const mien_zones*)(intptr_t)zones, (uint64_t)index, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1zones_1get_1vertices(JNIEnv *env, jobject self, jlong zones, jlong index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_zones_get_vertices((const mien_zones*)(intptr_t)zones, (uint64_t)index, (uint32_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1zones_1retain(JNIEnv *env, jobject self, jlong zones) {
    (void)env;
    (void)self;
    mien_zones_retain((mien_zones*)(intptr_t)zones);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1zones_1release(JNIEnv *env, jobject self, jlong zones) {
    (void)env;
    (void)self;
    mien_zones_release((mien_zones*)(intptr_t)zones);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1anthropometry_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_anthropometry_options_init((mien_anthropometry_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1landmarks_1add_1profile(JNIEnv *env, jobject self, jlong landmarks, jlong template_mesh, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_landmarks_add_profile((const mien_landmarks*)(intptr_t)landmarks, (const mien_mesh*)(intptr_t)template_mesh, (mien_landmarks**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1anthropometry(JNIEnv *env, jobject self, jlong session, jlong face, jlong landmarks, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_anthropometry((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)face, (const mien_landmarks*)(intptr_t)landmarks, (const mien_anthropometry_options*)(intptr_t)options, (mien_anthropometry**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1anthropometry_1get_1counts(JNIEnv *env, jobject self, jlong anthropometry, jlong count, jlong known_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_anthropometry_get_counts((const mien_anthropometry*)(intptr_t)anthropometry, (uint64_t*)(intptr_t)count, (uint64_t*)(intptr_t)known_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1anthropometry_1get_1name(JNIEnv *env, jobject self, jlong anthropometry, jlong index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_anthropometry_get_name((const mien_anthropometry*)(intptr_t)anthropometry, (uint64_t)index, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1anthropometry_1get_1value(JNIEnv *env, jobject self, jlong anthropometry, jlong index, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_anthropometry_get_value((const mien_anthropometry*)(intptr_t)anthropometry, (uint64_t)index, (mien_anthropometric_value*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1anthropometry_1get_1reason(JNIEnv *env, jobject self, jlong anthropometry, jlong index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_anthropometry_get_reason((const mien_anthropometry*)(intptr_t)anthropometry, (uint64_t)index, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1anthropometry_1get_1json(JNIEnv *env, jobject self, jlong anthropometry, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_anthropometry_get_json((const mien_anthropometry*)(intptr_t)anthropometry, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1anthropometry_1release(JNIEnv *env, jobject self, jlong anthropometry) {
    (void)env;
    (void)self;
    mien_anthropometry_release((mien_anthropometry*)(intptr_t)anthropometry);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1norms_1create(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jlong landmarks, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_norms_create((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (const mien_landmarks*)(intptr_t)landmarks, (const mien_anthropometry_options*)(intptr_t)options, (mien_norms**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1norms_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_norms_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_norms**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1norms_1save(JNIEnv *env, jobject self, jlong session, jlong norms, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_norms_save((mien_session*)(intptr_t)session, (const mien_norms*)(intptr_t)norms, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1norms_1get_1json(JNIEnv *env, jobject self, jlong norms, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_norms_get_json((const mien_norms*)(intptr_t)norms, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1norms_1release(JNIEnv *env, jobject self, jlong norms) {
    (void)env;
    (void)self;
    mien_norms_release((mien_norms*)(intptr_t)norms);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1measure_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_measure_options_init((mien_measure_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1volume(JNIEnv *env, jobject self, jlong session, jlong before, jlong after, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_volume((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)before, (const mien_mesh*)(intptr_t)after, (const mien_measure_options*)(intptr_t)options, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1distance(JNIEnv *env, jobject self, jlong session, jlong before, jlong after, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_distance((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)before, (const mien_mesh*)(intptr_t)after, (const mien_measure_options*)(intptr_t)options, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1surface_1distance(JNIEnv *env, jobject self, jlong session, jlong before, jlong after, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_surface_distance((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)before, (const mien_mesh*)(intptr_t)after, (const mien_measure_options*)(intptr_t)options, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1closed_1volume(JNIEnv *env, jobject self, jlong session, jlong mesh, jint close_rims, jlong volume_ml, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_closed_volume((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (int32_t)close_rims, (double*)(intptr_t)volume_ml, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1area(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong zone, jlong area_mm2, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_area((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const mien_zone*)(intptr_t)zone, (double*)(intptr_t)area_mm2, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1curvature(JNIEnv *env, jobject self, jlong session, jlong mesh, jdouble radius_mm, jint robust, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_curvature((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (double)radius_mm, (int32_t)robust, (const mien_measure_options*)(intptr_t)options, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1lengths(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong pairs, jlong pair_count, jlong straight_mm, jlong geodesic_mm, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_lengths((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const uint32_t*)(intptr_t)pairs, (uint64_t)pair_count, (double*)(intptr_t)straight_mm, (double*)(intptr_t)geodesic_mm, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1scan_1volume(JNIEnv *env, jobject self, jlong session, jlong before, jlong after, jint carry, jlong direction, jlong options, jlong coverage, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_scan_volume((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)before, (const mien_mesh*)(intptr_t)after, (int32_t)carry, (const double*)(intptr_t)direction, (const mien_measure_options*)(intptr_t)options, (double*)(intptr_t)coverage, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1align(JNIEnv *env, jobject self, jlong session, jlong moving, jlong target, jlong stable, jlong info, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_align((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)moving, (const mien_mesh*)(intptr_t)target, (const mien_zone*)(intptr_t)stable, (mien_zone_alignment*)(intptr_t)info, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1zones(JNIEnv *env, jobject self, jlong measurement, jlong zone_count, jlong zones_disjoint, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_zones((const mien_measurement*)(intptr_t)measurement, (uint32_t*)(intptr_t)zone_count, (int32_t*)(intptr_t)zones_disjoint, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1volume(JNIEnv *env, jobject self, jlong measurement, jint zone, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_volume((const mien_measurement*)(intptr_t)measurement, (int32_t)zone, (mien_zone_volume*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1distance(JNIEnv *env, jobject self, jlong measurement, jint zone, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_distance((const mien_measurement*)(intptr_t)measurement, (int32_t)zone, (mien_zone_distance*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1field(JNIEnv *env, jobject self, jlong measurement, jint field, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_field((const mien_measurement*)(intptr_t)measurement, (int32_t)field, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1json(JNIEnv *env, jobject self, jlong measurement, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_json((const mien_measurement*)(intptr_t)measurement, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1measurement_1release(JNIEnv *env, jobject self, jlong measurement) {
    (void)env;
    (void)self;
    mien_measurement_release((mien_measurement*)(intptr_t)measurement);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1asymmetry_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_asymmetry_options_init((mien_asymmetry_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1asymmetry(JNIEnv *env, jobject self, jlong session, jlong face, jlong template_mesh, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_asymmetry((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)face, (const mien_mesh*)(intptr_t)template_mesh, (const mien_asymmetry_options*)(intptr_t)options, (mien_measurement**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measurement_1get_1mirror_1plane(JNIEnv *env, jobject self, jlong measurement, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measurement_get_mirror_plane((const mien_measurement*)(intptr_t)measurement, (mien_mirror_plane*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1register_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_register_options_init((mien_register_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1register(JNIEnv *env, jobject self, jlong session, jlong model, jlong scan, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_register((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)scan, (const mien_register_options*)(intptr_t)options, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1registration_1mesh(JNIEnv *env, jobject self, jlong registration) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_registration_mesh((const mien_registration*)(intptr_t)registration);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1verdict(JNIEnv *env, jobject self, jlong registration, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_verdict((const mien_registration*)(intptr_t)registration, (mien_fit_verdict*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1expected_1error(JNIEnv *env, jobject self, jlong registration, jlong zone, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_expected_error((const mien_registration*)(intptr_t)registration, (const char*)(intptr_t)zone, (mien_expected_error*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1field(JNIEnv *env, jobject self, jlong registration, jint field, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_field((const mien_registration*)(intptr_t)registration, (int32_t)field, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1correspondence(JNIEnv *env, jobject self, jlong registration, jlong triangles, jlong barycentric, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_correspondence((const mien_registration*)(intptr_t)registration, (uint32_t*)(intptr_t)triangles, (double*)(intptr_t)barycentric, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1motion(JNIEnv *env, jobject self, jlong registration, jlong matrix, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_motion((const mien_registration*)(intptr_t)registration, (double*)(intptr_t)matrix, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1json(JNIEnv *env, jobject self, jlong registration, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_json((const mien_registration*)(intptr_t)registration, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1save(JNIEnv *env, jobject self, jlong session, jlong registration, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_save((mien_session*)(intptr_t)session, (const mien_registration*)(intptr_t)registration, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1create(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong weight, jlong residual, jlong standard_deviation, jint quality, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_create((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const mien_array_view*)(intptr_t)weight, (const mien_array_view*)(intptr_t)residual, (const mien_array_view*)(intptr_t)standard_deviation, (int32_t)quality, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1tie_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_tie_options_init((mien_tie_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1tie(JNIEnv *env, jobject self, jlong session, jlong model, jlong reference, jlong reference_scan, jlong registration, jlong scan, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_tie((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_registration*)(intptr_t)reference, (const mien_mesh*)(intptr_t)reference_scan, (const mien_registration*)(intptr_t)registration, (const mien_mesh*)(intptr_t)scan, (const mien_tie_options*)(intptr_t)options, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1registration_1retain(JNIEnv *env, jobject self, jlong registration) {
    (void)env;
    (void)self;
    mien_registration_retain((mien_registration*)(intptr_t)registration);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1registration_1release(JNIEnv *env, jobject self, jlong registration) {
    (void)env;
    (void)self;
    mien_registration_release((mien_registration*)(intptr_t)registration);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1surface_1transfer_1points(JNIEnv *env, jobject self, jlong session, jlong surface, jlong points, jdouble max_distance_mm, jlong triangles, jlong barycentric, jlong positions, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_surface_transfer_points((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)surface, (const mien_array_view*)(intptr_t)points, (double)max_distance_mm, (uint32_t*)(intptr_t)triangles, (double*)(intptr_t)barycentric, (double*)(intptr_t)positions, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1surface_1transfer_1zone(JNIEnv *env, jobject self, jlong session, jlong from, jlong vertices, jlong vertex_count, jlong to, jdouble max_distance_mm, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_surface_transfer_zone((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)from, (const uint32_t*)(intptr_t)vertices, (uint64_t)vertex_count, (const mien_mesh*)(intptr_t)to, (double)max_distance_mm, (uint32_t*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1surface_1transfer_1json(JNIEnv *env, jobject self, jlong session, jlong model, jlong fitted, jlong scan, jint what, jdouble max_distance_mm, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_surface_transfer_json((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)fitted, (const mien_mesh*)(intptr_t)scan, (int32_t)what, (double)max_distance_mm, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1batch_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_batch_options_init((mien_batch_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1ready_1scan_1create(JNIEnv *env, jobject self, jlong session, jlong scan, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_ready_scan_create((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)scan, (const mien_register_options*)(intptr_t)options, (mien_ready_scan**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1ready_1scan_1register(JNIEnv *env, jobject self, jlong session, jlong model, jlong scan, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_ready_scan_register((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_ready_scan*)(intptr_t)scan, (const mien_register_options*)(intptr_t)options, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1ready_1scan_1retain(JNIEnv *env, jobject self, jlong scan) {
    (void)env;
    (void)self;
    mien_ready_scan_retain((mien_ready_scan*)(intptr_t)scan);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1ready_1scan_1release(JNIEnv *env, jobject self, jlong scan) {
    (void)env;
    (void)self;
    mien_ready_scan_release((mien_ready_scan*)(intptr_t)scan);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1batch_1create(JNIEnv *env, jobject self, jlong session, jlong model, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_batch_create((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (mien_batch**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1batch_1add(JNIEnv *env, jobject self, jlong session, jlong batch, jlong scan, jlong options, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_batch_add((mien_session*)(intptr_t)session, (mien_batch*)(intptr_t)batch, (const mien_mesh*)(intptr_t)scan, (const mien_register_options*)(intptr_t)options, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1batch_1run(JNIEnv *env, jobject self, jlong session, jlong batch, jlong options, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_batch_run((mien_session*)(intptr_t)session, (mien_batch*)(intptr_t)batch, (const mien_batch_options*)(intptr_t)options, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1batch_1get_1counts(JNIEnv *env, jobject self, jlong batch, jlong scan_count, jlong run_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_batch_get_counts((const mien_batch*)(intptr_t)batch, (uint32_t*)(intptr_t)scan_count, (uint32_t*)(intptr_t)run_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1batch_1get_1registration(JNIEnv *env, jobject self, jlong batch, jint index, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_batch_get_registration((const mien_batch*)(intptr_t)batch, (int32_t)index, (mien_registration**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1batch_1retain(JNIEnv *env, jobject self, jlong batch) {
    (void)env;
    (void)self;
    mien_batch_retain((mien_batch*)(intptr_t)batch);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1batch_1release(JNIEnv *env, jobject self, jlong batch) {
    (void)env;
    (void)self;
    mien_batch_release((mien_batch*)(intptr_t)batch);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1spectral_1basis_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_spectral_basis_options_init((mien_spectral_basis_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1build(JNIEnv *env, jobject self, jlong session, jlong mean, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_build((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mean, (const mien_spectral_basis_options*)(intptr_t)options, (mien_spectral_basis**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_spectral_basis**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1save(JNIEnv *env, jobject self, jlong session, jlong basis, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_save((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1get_1counts(JNIEnv *env, jobject self, jlong basis, jlong vertex_count, jlong mode_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_get_counts((const mien_spectral_basis*)(intptr_t)basis, (uint64_t*)(intptr_t)vertex_count, (uint64_t*)(intptr_t)mode_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1get_1eigenvalues(JNIEnv *env, jobject self, jlong basis, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_get_eigenvalues((const mien_spectral_basis*)(intptr_t)basis, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1spectral_1basis_1retain(JNIEnv *env, jobject self, jlong basis) {
    (void)env;
    (void)self;
    mien_spectral_basis_retain((mien_spectral_basis*)(intptr_t)basis);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1spectral_1basis_1release(JNIEnv *env, jobject self, jlong basis) {
    (void)env;
    (void)self;
    mien_spectral_basis_release((mien_spectral_basis*)(intptr_t)basis);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1split(JNIEnv *env, jobject self, jlong session, jlong basis, jlong face, jlong k, jlong low, jlong high, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_split((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const mien_mesh*)(intptr_t)face, (uint64_t)k, (mien_mesh**)(intptr_t)low, (mien_mesh**)(intptr_t)high, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1assemble(JNIEnv *env, jobject self, jlong session, jlong basis, jlong low, jlong high, jlong k, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_assemble((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const mien_mesh*)(intptr_t)low, (const mien_mesh*)(intptr_t)high, (uint64_t)k, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1edit(JNIEnv *env, jobject self, jlong session, jlong basis, jlong face, jlong limits, jlong limit_count, jlong gains, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_edit((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const mien_mesh*)(intptr_t)face, (const uint64_t*)(intptr_t)limits, (uint64_t)limit_count, (const double*)(intptr_t)gains, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1mix(JNIEnv *env, jobject self, jlong session, jlong basis, jlong first, jlong second, jlong limits, jlong limit_count, jlong weights, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_mix((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const mien_mesh*)(intptr_t)first, (const mien_mesh*)(intptr_t)second, (const uint64_t*)(intptr_t)limits, (uint64_t)limit_count, (const double*)(intptr_t)weights, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1get_1vector(JNIEnv *env, jobject self, jlong basis, jlong mode, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_get_vector((const mien_spectral_basis*)(intptr_t)basis, (uint64_t)mode, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1get_1mass(JNIEnv *env, jobject self, jlong basis, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_get_mass((const mien_spectral_basis*)(intptr_t)basis, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1basis_1get_1mean(JNIEnv *env, jobject self, jlong basis, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_basis_get_mean((const mien_spectral_basis*)(intptr_t)basis, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1project(JNIEnv *env, jobject self, jlong session, jlong basis, jlong face, jlong mode_count, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_project((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const mien_mesh*)(intptr_t)face, (uint64_t)mode_count, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1spectral_1synthesize(JNIEnv *env, jobject self, jlong session, jlong basis, jlong coefficients, jlong row_count, jlong first_mode, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_spectral_synthesize((mien_session*)(intptr_t)session, (const mien_spectral_basis*)(intptr_t)basis, (const double*)(intptr_t)coefficients, (uint64_t)row_count, (uint64_t)first_mode, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1metric(JNIEnv *env, jobject self, jlong session, jint metric, jlong reference, jlong other, jlong value, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_metric((mien_session*)(intptr_t)session, (int32_t)metric, (const mien_mesh*)(intptr_t)reference, (const mien_mesh*)(intptr_t)other, (double*)(intptr_t)value, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1metric_1field(JNIEnv *env, jobject self, jlong session, jint metric, jlong reference, jlong other, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_metric_field((mien_session*)(intptr_t)session, (int32_t)metric, (const mien_mesh*)(intptr_t)reference, (const mien_mesh*)(intptr_t)other, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1metric_1roughness(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_metric_roughness((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1transfer_1expression(JNIEnv *env, jobject self, jlong session, jlong source_neutral, jlong source_expression, jlong target_neutral, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_transfer_expression((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)source_neutral, (const mien_mesh*)(intptr_t)source_expression, (const mien_mesh*)(intptr_t)target_neutral, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1blendshape_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_blendshape_options_init((mien_blendshape_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1train(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jlong expression, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_train((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (const char*)(intptr_t)expression, (const mien_blendshape_options*)(intptr_t)options, (mien_blendshape_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_blendshape_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1save(JNIEnv *env, jobject self, jlong session, jlong model, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_save((mien_session*)(intptr_t)session, (const mien_blendshape_model*)(intptr_t)model, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1get_1mean(JNIEnv *env, jobject self, jlong model, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_get_mean((const mien_blendshape_model*)(intptr_t)model, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1predict(JNIEnv *env, jobject self, jlong session, jlong model, jlong basis, jlong k, jlong neutral, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_predict((mien_session*)(intptr_t)session, (const mien_blendshape_model*)(intptr_t)model, (const mien_spectral_basis*)(intptr_t)basis, (uint64_t)k, (const mien_mesh*)(intptr_t)neutral, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1blendshape_1model_1search(JNIEnv *env, jobject self, jlong session, jlong model, jlong basis, jlong dataset_path, jlong expression, jlong candidates, jint candidate_count, jlong options, jlong choices, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_blendshape_model_search((mien_session*)(intptr_t)session, (const mien_blendshape_model*)(intptr_t)model, (const mien_spectral_basis*)(intptr_t)basis, (const char*)(intptr_t)dataset_path, (const char*)(intptr_t)expression, (const uint64_t*)(intptr_t)candidates, (uint32_t)candidate_count, (const mien_blendshape_options*)(intptr_t)options, (mien_band_choice*)(intptr_t)choices, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1blendshape_1model_1retain(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_blendshape_model_retain((mien_blendshape_model*)(intptr_t)model);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1blendshape_1model_1release(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_blendshape_model_release((mien_blendshape_model*)(intptr_t)model);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1dataset_1writer_1create(JNIEnv *env, jobject self, jlong session, jlong topology, jlong expression_names, jint expression_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_dataset_writer_create((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)topology, (const char* const*)(intptr_t)expression_names, (uint32_t)expression_count, (mien_dataset_writer**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1dataset_1writer_1add(JNIEnv *env, jobject self, jlong writer, jlong positions, jint subject, jint expression, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_dataset_writer_add((mien_dataset_writer*)(intptr_t)writer, (const mien_array_view*)(intptr_t)positions, (int32_t)subject, (int32_t)expression, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1dataset_1writer_1save(JNIEnv *env, jobject self, jlong session, jlong writer, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_dataset_writer_save((mien_session*)(intptr_t)session, (const mien_dataset_writer*)(intptr_t)writer, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1dataset_1writer_1release(JNIEnv *env, jobject self, jlong writer) {
    (void)env;
    (void)self;
    mien_dataset_writer_release((mien_dataset_writer*)(intptr_t)writer);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_expression_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1load_1memory(JNIEnv *env, jobject self, jlong session, jlong data, jlong size, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_load_memory((mien_session*)(intptr_t)session, (const void*)(intptr_t)data, (uint64_t)size, (mien_expression_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1save(JNIEnv *env, jobject self, jlong session, jlong model, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_save((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1expression_1model_1retain(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_expression_model_retain((mien_expression_model*)(intptr_t)model);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1expression_1model_1release(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_expression_model_release((mien_expression_model*)(intptr_t)model);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1get_1counts(JNIEnv *env, jobject self, jlong model, jlong vertex_count, jlong identity_modes, jlong expression_modes, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_get_counts((const mien_expression_model*)(intptr_t)model, (uint64_t*)(intptr_t)vertex_count, (uint32_t*)(intptr_t)identity_modes, (uint32_t*)(intptr_t)expression_modes, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1get_1json(JNIEnv *env, jobject self, jlong model, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_get_json((const mien_expression_model*)(intptr_t)model, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1synthesize(JNIEnv *env, jobject self, jlong session, jlong model, jlong identity, jlong expression, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_synthesize((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_array_view*)(intptr_t)identity, (const mien_array_view*)(intptr_t)expression, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1sample(JNIEnv *env, jobject self, jlong session, jlong model, jlong seed, jlong expression, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_sample((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (uint64_t)seed, (const char*)(intptr_t)expression, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1neutralize_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_neutralize_options_init((mien_neutralize_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralize(JNIEnv *env, jobject self, jlong session, jlong model, jlong fitted, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralize((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_registration*)(intptr_t)fitted, (const mien_neutralize_options*)(intptr_t)options, (mien_neutralization**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralize_1mesh(JNIEnv *env, jobject self, jlong session, jlong model, jlong face, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralize_mesh((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)face, (const mien_neutralize_options*)(intptr_t)options, (mien_neutralization**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jlong JNICALL Java_mien_RawJni_mien_1neutralization_1mesh(JNIEnv *env, jobject self, jlong neutralization) {
    (void)env;
    (void)self;
    return (jlong)(intptr_t)mien_neutralization_mesh((const mien_neutralization*)(intptr_t)neutralization);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1get_1counts(JNIEnv *env, jobject self, jlong neutralization, jlong vertex_count, jlong identity_modes, jlong expression_modes, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_get_counts((const mien_neutralization*)(intptr_t)neutralization, (uint64_t*)(intptr_t)vertex_count, (uint32_t*)(intptr_t)identity_modes, (uint32_t*)(intptr_t)expression_modes, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1get_1coordinates(JNIEnv *env, jobject self, jlong neutralization, jlong identity, jlong expression, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_get_coordinates((const mien_neutralization*)(intptr_t)neutralization, (double*)(intptr_t)identity, (double*)(intptr_t)expression, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1get_1uncertainty(JNIEnv *env, jobject self, jlong neutralization, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_get_uncertainty((const mien_neutralization*)(intptr_t)neutralization, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1get_1reading(JNIEnv *env, jobject self, jlong neutralization, jint reading, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_get_reading((const mien_neutralization*)(intptr_t)neutralization, (int32_t)reading, (mien_zone_reading*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1get_1json(JNIEnv *env, jobject self, jlong neutralization, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_get_json((const mien_neutralization*)(intptr_t)neutralization, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1neutralization_1release(JNIEnv *env, jobject self, jlong neutralization) {
    (void)env;
    (void)self;
    mien_neutralization_release((mien_neutralization*)(intptr_t)neutralization);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralization_1apply_1to_1scan(JNIEnv *env, jobject self, jlong session, jlong neutralization, jlong scan, jdouble max_distance_mm, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralization_apply_to_scan((mien_session*)(intptr_t)session, (const mien_neutralization*)(intptr_t)neutralization, (const mien_mesh*)(intptr_t)scan, (double)max_distance_mm, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1transfer(JNIEnv *env, jobject self, jlong session, jlong model, jlong source, jlong target, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_transfer((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_neutralization*)(intptr_t)source, (const mien_neutralization*)(intptr_t)target, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1evaluate_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_evaluate_options_init((mien_evaluate_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1evaluate_1neutralization(JNIEnv *env, jobject self, jlong session, jlong model, jlong dataset_path, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_evaluate_neutralization((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const char*)(intptr_t)dataset_path, (const mien_evaluate_options*)(intptr_t)options, (mien_evaluation**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1evaluation_1get_1json(JNIEnv *env, jobject self, jlong evaluation, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_evaluation_get_json((const mien_evaluation*)(intptr_t)evaluation, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1evaluation_1release(JNIEnv *env, jobject self, jlong evaluation) {
    (void)env;
    (void)self;
    mien_evaluation_release((mien_evaluation*)(intptr_t)evaluation);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1follow_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_follow_options_init((mien_follow_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1follower_1create(JNIEnv *env, jobject self, jlong session, jlong model, jlong start, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_follower_create((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_registration*)(intptr_t)start, (const mien_follow_options*)(intptr_t)options, (mien_follower**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1follower_1fit(JNIEnv *env, jobject self, jlong session, jlong follower, jlong points, jint width, jint height, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_follower_fit((mien_session*)(intptr_t)session, (mien_follower*)(intptr_t)follower, (const mien_array_view*)(intptr_t)points, (int32_t)width, (int32_t)height, (mien_follow_state*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1follower_1get_1mesh(JNIEnv *env, jobject self, jlong follower, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_follower_get_mesh((const mien_follower*)(intptr_t)follower, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1follower_1get_1motion(JNIEnv *env, jobject self, jlong follower, jlong matrix, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_follower_get_motion((const mien_follower*)(intptr_t)follower, (double*)(intptr_t)matrix, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1follower_1retain(JNIEnv *env, jobject self, jlong follower) {
    (void)env;
    (void)self;
    mien_follower_retain((mien_follower*)(intptr_t)follower);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1follower_1release(JNIEnv *env, jobject self, jlong follower) {
    (void)env;
    (void)self;
    mien_follower_release((mien_follower*)(intptr_t)follower);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1geodesic_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_geodesic_options_init((mien_geodesic_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1measure_1geodesic(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong sources, jlong source_count, jlong options, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_measure_geodesic((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const uint32_t*)(intptr_t)sources, (uint64_t)source_count, (const mien_geodesic_options*)(intptr_t)options, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1build_1quadric(JNIEnv *env, jobject self, jlong session, jlong mesh, jint level_count, jdouble factor, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_build_quadric((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (uint32_t)level_count, (double)factor, (mien_hierarchy**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1build_1connectivity(JNIEnv *env, jobject self, jlong session, jlong mesh, jint level_count, jint stride, jint radius, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_build_connectivity((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (uint32_t)level_count, (uint32_t)stride, (uint32_t)radius, (mien_hierarchy**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_hierarchy**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1save(JNIEnv *env, jobject self, jlong session, jlong hierarchy, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_save((mien_session*)(intptr_t)session, (const mien_hierarchy*)(intptr_t)hierarchy, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1get_1level_1count(JNIEnv *env, jobject self, jlong hierarchy, jlong level_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_get_level_count((const mien_hierarchy*)(intptr_t)hierarchy, (uint32_t*)(intptr_t)level_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1get_1level(JNIEnv *env, jobject self, jlong hierarchy, jint level, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_get_level((const mien_hierarchy*)(intptr_t)hierarchy, (uint32_t)level, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1apply(JNIEnv *env, jobject self, jlong hierarchy, jint level, jint direction, jlong values, jlong row_count, jlong channel_count, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_apply((const mien_hierarchy*)(intptr_t)hierarchy, (uint32_t)level, (int32_t)direction, (const double*)(intptr_t)values, (uint64_t)row_count, (uint64_t)channel_count, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1hierarchy_1get_1map(JNIEnv *env, jobject self, jlong hierarchy, jint level, jint direction, jlong rows, jlong columns, jlong values, jlong capacity, jlong count, jlong row_count, jlong column_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_hierarchy_get_map((const mien_hierarchy*)(intptr_t)hierarchy, (uint32_t)level, (int32_t)direction, (uint32_t*)(intptr_t)rows, (uint32_t*)(intptr_t)columns, (double*)(intptr_t)values, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (uint64_t*)(intptr_t)row_count, (uint64_t*)(intptr_t)column_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1hierarchy_1retain(JNIEnv *env, jobject self, jlong hierarchy) {
    (void)env;
    (void)self;
    mien_hierarchy_retain((mien_hierarchy*)(intptr_t)hierarchy);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1hierarchy_1release(JNIEnv *env, jobject self, jlong hierarchy) {
    (void)env;
    (void)self;
    mien_hierarchy_release((mien_hierarchy*)(intptr_t)hierarchy);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1inspect(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_inspect((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1clean(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong min_triangles, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_clean((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (uint64_t)min_triangles, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1transform(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong matrix, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_transform((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (const double*)(intptr_t)matrix, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1turn_1over(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_turn_over((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1decimate(JNIEnv *env, jobject self, jlong session, jlong mesh, jlong vertex_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_decimate((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)mesh, (uint64_t)vertex_count, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1mesh_1check_1same_1unit(JNIEnv *env, jobject self, jlong first, jlong second, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_mesh_check_same_unit((const mien_mesh*)(intptr_t)first, (const mien_mesh*)(intptr_t)second, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1model_1fit_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_model_fit_options_init((mien_model_fit_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1fit(JNIEnv *env, jobject self, jlong session, jlong model, jlong target, jlong options, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_fit((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)target, (const mien_model_fit_options*)(intptr_t)options, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1model_1synthesize(JNIEnv *env, jobject self, jlong session, jlong model, jlong coefficients, jlong coefficient_count, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_model_synthesize((mien_session*)(intptr_t)session, (const mien_model*)(intptr_t)model, (const double*)(intptr_t)coefficients, (uint64_t)coefficient_count, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1registration_1get_1coefficients(JNIEnv *env, jobject self, jlong session, jlong registration, jlong model, jdouble ridge_mm2, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_registration_get_coefficients((mien_session*)(intptr_t)session, (const mien_registration*)(intptr_t)registration, (const mien_model*)(intptr_t)model, (double)ridge_mm2, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1network_1evaluation_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_network_evaluation_options_init((mien_network_evaluation_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1network_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_network_options_init((mien_network_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_network**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1load_1memory(JNIEnv *env, jobject self, jlong session, jlong data, jlong size, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_load_memory((mien_session*)(intptr_t)session, (const void*)(intptr_t)data, (uint64_t)size, (mien_network**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1get_1counts(JNIEnv *env, jobject self, jlong network, jlong vertex_count, jlong code_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_get_counts((const mien_network*)(intptr_t)network, (uint64_t*)(intptr_t)vertex_count, (uint64_t*)(intptr_t)code_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1get_1json(JNIEnv *env, jobject self, jlong network, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_get_json((const mien_network*)(intptr_t)network, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1get_1mean(JNIEnv *env, jobject self, jlong network, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_get_mean((const mien_network*)(intptr_t)network, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1encode(JNIEnv *env, jobject self, jlong session, jlong network, jlong face, jlong options, jlong motion, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_encode((mien_session*)(intptr_t)session, (const mien_network*)(intptr_t)network, (const mien_mesh*)(intptr_t)face, (const mien_network_options*)(intptr_t)options, (double*)(intptr_t)motion, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1decode(JNIEnv *env, jobject self, jlong session, jlong network, jlong code, jlong code_count, jlong motion, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_decode((mien_session*)(intptr_t)session, (const mien_network*)(intptr_t)network, (const double*)(intptr_t)code, (uint64_t)code_count, (const double*)(intptr_t)motion, (const mien_network_options*)(intptr_t)options, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1apply(JNIEnv *env, jobject self, jlong session, jlong network, jlong face, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_apply((mien_session*)(intptr_t)session, (const mien_network*)(intptr_t)network, (const mien_mesh*)(intptr_t)face, (const mien_network_options*)(intptr_t)options, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1get_1bands(JNIEnv *env, jobject self, jlong network, jlong low_code_count, jlong band_limit, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_get_bands((const mien_network*)(intptr_t)network, (uint64_t*)(intptr_t)low_code_count, (int64_t*)(intptr_t)band_limit, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1mix(JNIEnv *env, jobject self, jlong session, jlong network, jlong a, jlong b, jdouble low_weight, jdouble high_weight, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_mix((mien_session*)(intptr_t)session, (const mien_network*)(intptr_t)network, (const mien_mesh*)(intptr_t)a, (const mien_mesh*)(intptr_t)b, (double)low_weight, (double)high_weight, (const mien_network_options*)(intptr_t)options, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1sample(JNIEnv *env, jobject self, jlong network, jlong seed, jlong number, jdouble spread, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_sample((const mien_network*)(intptr_t)network, (uint64_t)seed, (uint64_t)number, (double)spread, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1network_1evaluate(JNIEnv *env, jobject self, jlong session, jlong network, jlong dataset_path, jlong options, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_network_evaluate((mien_session*)(intptr_t)session, (const mien_network*)(intptr_t)network, (const char*)(intptr_t)dataset_path, (const mien_network_evaluation_options*)(intptr_t)options, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1network_1retain(JNIEnv *env, jobject self, jlong network) {
    (void)env;
    (void)self;
    mien_network_retain((mien_network*)(intptr_t)network);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1network_1release(JNIEnv *env, jobject self, jlong network) {
    (void)env;
    (void)self;
    mien_network_release((mien_network*)(intptr_t)network);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1train(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jint kind, jint neutral_only, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_train((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (int32_t)kind, (int32_t)neutral_only, (mien_representation**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1representation_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_representation_options_init((mien_representation_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1train_1with_1options(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jint kind, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_train_with_options((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (int32_t)kind, (const mien_representation_options*)(intptr_t)options, (mien_representation**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_representation**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1save(JNIEnv *env, jobject self, jlong session, jlong representation, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_save((mien_session*)(intptr_t)session, (const mien_representation*)(intptr_t)representation, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1get_1counts(JNIEnv *env, jobject self, jlong representation, jlong vertex_count, jlong channel_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_get_counts((const mien_representation*)(intptr_t)representation, (uint64_t*)(intptr_t)vertex_count, (uint64_t*)(intptr_t)channel_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1encode(JNIEnv *env, jobject self, jlong session, jlong representation, jlong face, jlong motion, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_encode((mien_session*)(intptr_t)session, (const mien_representation*)(intptr_t)representation, (const mien_mesh*)(intptr_t)face, (double*)(intptr_t)motion, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1representation_1decode(JNIEnv *env, jobject self, jlong session, jlong representation, jlong features, jlong row_count, jlong motion, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_representation_decode((mien_session*)(intptr_t)session, (const mien_representation*)(intptr_t)representation, (const double*)(intptr_t)features, (uint64_t)row_count, (const double*)(intptr_t)motion, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1representation_1retain(JNIEnv *env, jobject self, jlong representation) {
    (void)env;
    (void)self;
    mien_representation_retain((mien_representation*)(intptr_t)representation);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1representation_1release(JNIEnv *env, jobject self, jlong representation) {
    (void)env;
    (void)self;
    mien_representation_release((mien_representation*)(intptr_t)representation);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1score_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_score_options_init((mien_score_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1train(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jlong grades, jlong grade_count, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_train((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (const double*)(intptr_t)grades, (uint64_t)grade_count, (const mien_score_options*)(intptr_t)options, (mien_score_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1load(JNIEnv *env, jobject self, jlong session, jlong path, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_load((mien_session*)(intptr_t)session, (const char*)(intptr_t)path, (mien_score_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1save(JNIEnv *env, jobject self, jlong session, jlong model, jlong path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_save((mien_session*)(intptr_t)session, (const mien_score_model*)(intptr_t)model, (const char*)(intptr_t)path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1predict(JNIEnv *env, jobject self, jlong session, jlong model, jlong face, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_predict((mien_session*)(intptr_t)session, (const mien_score_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)face, (mien_score_prediction*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1simulate(JNIEnv *env, jobject self, jlong session, jlong model, jlong face, jdouble target, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_simulate((mien_session*)(intptr_t)session, (const mien_score_model*)(intptr_t)model, (const mien_mesh*)(intptr_t)face, (double)target, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1get_1latent(JNIEnv *env, jobject self, jlong model, jint component, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_get_latent((const mien_score_model*)(intptr_t)model, (int32_t)component, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1score_1model_1get_1json(JNIEnv *env, jobject self, jlong model, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_score_model_get_json((const mien_score_model*)(intptr_t)model, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1score_1model_1retain(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_score_model_retain((mien_score_model*)(intptr_t)model);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1score_1model_1release(JNIEnv *env, jobject self, jlong model) {
    (void)env;
    (void)self;
    mien_score_model_release((mien_score_model*)(intptr_t)model);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1statistics_1agreement(JNIEnv *env, jobject self, jlong session, jlong ratings, jlong subject_count, jint rater_count, jint grade_count, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_statistics_agreement((mien_session*)(intptr_t)session, (const int32_t*)(intptr_t)ratings, (uint64_t)subject_count, (uint32_t)rater_count, (int32_t)grade_count, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1statistics_1repeatability(JNIEnv *env, jobject self, jlong session, jlong values, jlong subjects, jlong value_count, jlong blanks, jlong blank_count, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_statistics_repeatability((mien_session*)(intptr_t)session, (const double*)(intptr_t)values, (const int32_t*)(intptr_t)subjects, (uint64_t)value_count, (const double*)(intptr_t)blanks, (uint64_t)blank_count, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1statistics_1bland_1altman(JNIEnv *env, jobject self, jlong session, jlong first, jlong second, jlong value_count, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_statistics_bland_altman((mien_session*)(intptr_t)session, (const double*)(intptr_t)first, (const double*)(intptr_t)second, (uint64_t)value_count, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1series_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_series_options_init((mien_series_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralize_1series(JNIEnv *env, jobject self, jlong session, jlong model, jlong faces, jint face_count, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralize_series((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_mesh* const*)(intptr_t)faces, (uint32_t)face_count, (const mien_series_options*)(intptr_t)options, (mien_series**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1series_1get_1mesh(JNIEnv *env, jobject self, jlong series, jint index, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_series_get_mesh((const mien_series*)(intptr_t)series, (int32_t)index, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1series_1get_1json(JNIEnv *env, jobject self, jlong series, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_series_get_json((const mien_series*)(intptr_t)series, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1series_1release(JNIEnv *env, jobject self, jlong series) {
    (void)env;
    (void)self;
    mien_series_release((mien_series*)(intptr_t)series);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1study_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_study_options_init((mien_study_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1create(JNIEnv *env, jobject self, jlong session, jlong registrations, jint registration_count, jlong expressions, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_create((mien_session*)(intptr_t)session, (const mien_registration* const*)(intptr_t)registrations, (uint32_t)registration_count, (const mien_expression_model*)(intptr_t)expressions, (const mien_study_options*)(intptr_t)options, (mien_study**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1create_1from_1meshes(JNIEnv *env, jobject self, jlong session, jlong faces, jint face_count, jlong normal_sd, jlong weights, jlong expressions, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_create_from_meshes((mien_session*)(intptr_t)session, (const mien_mesh* const*)(intptr_t)faces, (uint32_t)face_count, (const mien_array_view*)(intptr_t)normal_sd, (const mien_array_view*)(intptr_t)weights, (const mien_expression_model*)(intptr_t)expressions, (const mien_study_options*)(intptr_t)options, (mien_study**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1counts(JNIEnv *env, jobject self, jlong study, jlong visit_count, jlong zone_count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_counts((const mien_study*)(intptr_t)study, (uint32_t*)(intptr_t)visit_count, (uint32_t*)(intptr_t)zone_count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1zone_1name(JNIEnv *env, jobject self, jlong study, jint zone, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_zone_name((const mien_study*)(intptr_t)study, (int32_t)zone, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1expression(JNIEnv *env, jobject self, jlong study, jint visit, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_expression((const mien_study*)(intptr_t)study, (int32_t)visit, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1mesh(JNIEnv *env, jobject self, jlong study, jint visit, jint frame, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_mesh((const mien_study*)(intptr_t)study, (int32_t)visit, (int32_t)frame, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1field(JNIEnv *env, jobject self, jlong study, jint visit, jint field, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_field((const mien_study*)(intptr_t)study, (int32_t)visit, (int32_t)field, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1distances(JNIEnv *env, jobject self, jlong study, jint first, jint second, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_distances((const mien_study*)(intptr_t)study, (int32_t)first, (int32_t)second, (double*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1alignment(JNIEnv *env, jobject self, jlong study, jint first, jint second, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_alignment((const mien_study*)(intptr_t)study, (int32_t)first, (int32_t)second, (mien_zone_alignment*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1change(JNIEnv *env, jobject self, jlong study, jint first, jint second, jint zone, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_change((const mien_study*)(intptr_t)study, (int32_t)first, (int32_t)second, (int32_t)zone, (mien_study_change*)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1study_1get_1json(JNIEnv *env, jobject self, jlong study, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_study_get_json((const mien_study*)(intptr_t)study, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1study_1retain(JNIEnv *env, jobject self, jlong study) {
    (void)env;
    (void)self;
    mien_study_retain((mien_study*)(intptr_t)study);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1study_1release(JNIEnv *env, jobject self, jlong study) {
    (void)env;
    (void)self;
    mien_study_release((mien_study*)(intptr_t)study);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1template_1check(JNIEnv *env, jobject self, jlong session, jlong template_mesh, jlong landmarks, jint mirror, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_template_check((mien_session*)(intptr_t)session, (const mien_mesh*)(intptr_t)template_mesh, (const mien_landmarks*)(intptr_t)landmarks, (int32_t)mirror, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1train_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_train_options_init((mien_train_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1train(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_train((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (const mien_train_options*)(intptr_t)options, (mien_expression_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1shard_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_shard_options_init((mien_shard_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1shard_1create(JNIEnv *env, jobject self, jlong session, jlong dataset_path, jlong options, jlong shard_path, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_shard_create((mien_session*)(intptr_t)session, (const char*)(intptr_t)dataset_path, (const mien_shard_options*)(intptr_t)options, (const char*)(intptr_t)shard_path, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1expression_1model_1merge(JNIEnv *env, jobject self, jlong session, jlong shard_paths, jint shard_count, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_expression_model_merge((mien_session*)(intptr_t)session, (const char* const*)(intptr_t)shard_paths, (uint32_t)shard_count, (const mien_train_options*)(intptr_t)options, (mien_expression_model**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1visits_1options_1init(JNIEnv *env, jobject self, jlong options, jlong struct_size) {
    (void)env;
    (void)self;
    mien_visits_options_init((mien_visits_options*)(intptr_t)options, (size_t)struct_size);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1neutralize_1visits(JNIEnv *env, jobject self, jlong session, jlong model, jlong faces, jint face_count, jlong options, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_neutralize_visits((mien_session*)(intptr_t)session, (const mien_expression_model*)(intptr_t)model, (const mien_mesh* const*)(intptr_t)faces, (uint32_t)face_count, (const mien_visits_options*)(intptr_t)options, (mien_visits**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1visits_1get_1mesh(JNIEnv *env, jobject self, jlong visits, jint index, jlong out, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_visits_get_mesh((const mien_visits*)(intptr_t)visits, (int32_t)index, (mien_mesh**)(intptr_t)out, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1visits_1get_1expression(JNIEnv *env, jobject self, jlong visits, jint index, jlong dst, jlong capacity, jlong count, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_visits_get_expression((const mien_visits*)(intptr_t)visits, (int32_t)index, (char*)(intptr_t)dst, (uint64_t)capacity, (uint64_t*)(intptr_t)count, (mien_error*)(intptr_t)error);
}

JNIEXPORT jint JNICALL Java_mien_RawJni_mien_1visits_1get_1removed_1volume(JNIEnv *env, jobject self, jlong visits, jint first, jint second, jlong zone, jlong removed_ml, jlong sd_ml, jlong error) {
    (void)env;
    (void)self;
    return (jint)mien_visits_get_removed_volume((const mien_visits*)(intptr_t)visits, (int32_t)first, (int32_t)second, (const mien_zone*)(intptr_t)zone, (double*)(intptr_t)removed_ml, (double*)(intptr_t)sd_ml, (mien_error*)(intptr_t)error);
}

JNIEXPORT void JNICALL Java_mien_RawJni_mien_1visits_1release(JNIEnv *env, jobject self, jlong visits) {
    (void)env;
    (void)self;
    mien_visits_release((mien_visits*)(intptr_t)visits);
}

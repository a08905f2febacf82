package mien;

// Written by abi/generate_bindings.py.
import static java.lang.foreign.ValueLayout.JAVA_DOUBLE;
import static java.lang.foreign.ValueLayout.JAVA_INT;
import static java.lang.foreign.ValueLayout.JAVA_LONG;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.MemorySegment;
import java.lang.invoke.MethodHandle;

/** Raw through the Foreign Function API: Java 22 and later, no C. */
final class RawForeign implements Raw {
    private final ForeignLibrary library = new ForeignLibrary();

    @Override public long address(java.nio.ByteBuffer memory) { return MemorySegment.ofBuffer(memory).address(); }
    @Override public java.nio.ByteBuffer memory(long address, long bytes) {
        return MemorySegment.ofAddress(address).reinterpret(bytes).asByteBuffer();
    }
    @Override public long progressFunction() { return library.progress; }
    @Override public long logFunction() { return library.log; }

    private final MethodHandle mien_status_name = library.find("mien_status_name", FunctionDescriptor.of(JAVA_LONG, JAVA_INT));
    @Override public long mien_status_name(int status) {
        try { return (long) mien_status_name.invokeExact(status); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_version_number = library.find("mien_version_number", FunctionDescriptor.of(JAVA_INT));
    @Override public int mien_version_number() {
        try { return (int) mien_version_number.invokeExact(); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_version_string = library.find("mien_version_string", FunctionDescriptor.of(JAVA_LONG));
    @Override public long mien_version_string() {
        try { return (long) mien_version_string.invokeExact(); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_build_id = library.find("mien_build_id", FunctionDescriptor.of(JAVA_LONG));
    @Override public long mien_build_id() {
        try { return (long) mien_build_id.invokeExact(); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_session_options_init = library.find("mien_session_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_session_options_init(long options, long structSize) {
        try { mien_session_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_session_create = library.find("mien_session_create", FunctionDescriptor.of(JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_session_create(int abiVersion, long out, long error) {
        try { return (int) mien_session_create.invokeExact(abiVersion, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_session_create_with_options = library.find("mien_session_create_with_options", FunctionDescriptor.of(JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_session_create_with_options(int abiVersion, long options, long out, long error) {
        try { return (int) mien_session_create_with_options.invokeExact(abiVersion, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_session_release = library.find("mien_session_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_session_release(long session) {
        try { mien_session_release.invokeExact(session); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_cancel_create = library.find("mien_cancel_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_cancel_create(long out, long error) {
        try { return (int) mien_cancel_create.invokeExact(out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_cancel_request = library.find("mien_cancel_request", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_cancel_request(long cancel) {
        try { mien_cancel_request.invokeExact(cancel); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_cancel_release = library.find("mien_cancel_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_cancel_release(long cancel) {
        try { mien_cancel_release.invokeExact(cancel); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_session_hash_file = library.find("mien_session_hash_file", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_session_hash_file(long session, long path, long dst, long capacity, long count, long error) {
        try { return (int) mien_session_hash_file.invokeExact(session, path, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_arrays_init = library.find("mien_mesh_arrays_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_mesh_arrays_init(long arrays, long structSize) {
        try { mien_mesh_arrays_init.invokeExact(arrays, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_create = library.find("mien_mesh_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_create(long session, long arrays, long out, long error) {
        try { return (int) mien_mesh_create.invokeExact(session, arrays, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_load = library.find("mien_mesh_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_load(long session, long path, long out, long error) {
        try { return (int) mien_mesh_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_save = library.find("mien_mesh_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_save(long session, long mesh, long path, long error) {
        try { return (int) mien_mesh_save.invokeExact(session, mesh, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_counts = library.find("mien_mesh_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_counts(long mesh, long vertexCount, long triangleCount, long error) {
        try { return (int) mien_mesh_get_counts.invokeExact(mesh, vertexCount, triangleCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_positions = library.find("mien_mesh_get_positions", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_positions(long mesh, int dtype, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_positions.invokeExact(mesh, dtype, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_triangles = library.find("mien_mesh_get_triangles", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_triangles(long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_triangles.invokeExact(mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_colors = library.find("mien_mesh_get_colors", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_colors(long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_colors.invokeExact(mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_format_count = library.find("mien_mesh_format_count", FunctionDescriptor.of(JAVA_INT));
    @Override public int mien_mesh_format_count() {
        try { return (int) mien_mesh_format_count.invokeExact(); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_format_extension = library.find("mien_mesh_format_extension", FunctionDescriptor.of(JAVA_LONG, JAVA_INT));
    @Override public long mien_mesh_format_extension(int format) {
        try { return (long) mien_mesh_format_extension.invokeExact(format); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_format_description = library.find("mien_mesh_format_description", FunctionDescriptor.of(JAVA_LONG, JAVA_INT));
    @Override public long mien_mesh_format_description(int format) {
        try { return (long) mien_mesh_format_description.invokeExact(format); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_format_writes = library.find("mien_mesh_format_writes", FunctionDescriptor.of(JAVA_INT, JAVA_INT));
    @Override public int mien_mesh_format_writes(int format) {
        try { return (int) mien_mesh_format_writes.invokeExact(format); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_texture = library.find("mien_mesh_get_texture", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_texture(long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_texture.invokeExact(mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_texture_triangles = library.find("mien_mesh_get_texture_triangles", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_texture_triangles(long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_texture_triangles.invokeExact(mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_triangle_materials = library.find("mien_mesh_get_triangle_materials", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_triangle_materials(long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_triangle_materials.invokeExact(mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_material_counts = library.find("mien_mesh_get_material_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_material_counts(long mesh, long materialCount, long imageCount, long error) {
        try { return (int) mien_mesh_get_material_counts.invokeExact(mesh, materialCount, imageCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_material = library.find("mien_mesh_get_material", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_material(long mesh, long material, long image, long red, long green, long blue, long error) {
        try { return (int) mien_mesh_get_material.invokeExact(mesh, material, image, red, green, blue, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_material_name = library.find("mien_mesh_get_material_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_material_name(long mesh, long material, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_material_name.invokeExact(mesh, material, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_image_name = library.find("mien_mesh_get_image_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_image_name(long mesh, long image, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_image_name.invokeExact(mesh, image, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_image_file = library.find("mien_mesh_get_image_file", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_image_file(long mesh, long image, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_image_file.invokeExact(mesh, image, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_image_size = library.find("mien_mesh_get_image_size", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_image_size(long mesh, long image, long width, long height, long error) {
        try { return (int) mien_mesh_get_image_size.invokeExact(mesh, image, width, height, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_get_image_pixels = library.find("mien_mesh_get_image_pixels", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_get_image_pixels(long session, long mesh, long image, long rowStrideBytes, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_get_image_pixels.invokeExact(session, mesh, image, rowStrideBytes, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_save_targets = library.find("mien_mesh_save_targets", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_save_targets(long session, long mesh, long targets, long names, long targetCount, long path, long error) {
        try { return (int) mien_mesh_save_targets.invokeExact(session, mesh, targets, names, targetCount, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_load_target = library.find("mien_mesh_load_target", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_load_target(long session, long path, long name, long out, long error) {
        try { return (int) mien_mesh_load_target.invokeExact(session, path, name, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_positions_view = library.find("mien_mesh_positions_view", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_positions_view(long mesh, long data, long count, long error) {
        try { return (int) mien_mesh_positions_view.invokeExact(mesh, data, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_retain = library.find("mien_mesh_retain", FunctionDescriptor.of(JAVA_LONG, JAVA_LONG));
    @Override public long mien_mesh_retain(long mesh) {
        try { return (long) mien_mesh_retain.invokeExact(mesh); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_release = library.find("mien_mesh_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_mesh_release(long mesh) {
        try { mien_mesh_release.invokeExact(mesh); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_options_init = library.find("mien_model_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_model_options_init(long options, long structSize) {
        try { mien_model_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_build = library.find("mien_model_build", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_build(long session, long templateMesh, long options, long out, long error) {
        try { return (int) mien_model_build.invokeExact(session, templateMesh, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_load = library.find("mien_model_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_load(long session, long path, long out, long error) {
        try { return (int) mien_model_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_load_memory = library.find("mien_model_load_memory", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_load_memory(long session, long data, long size, long out, long error) {
        try { return (int) mien_model_load_memory.invokeExact(session, data, size, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_load_trusted = library.find("mien_model_load_trusted", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_load_trusted(long session, long path, long out, long error) {
        try { return (int) mien_model_load_trusted.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_save = library.find("mien_model_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_save(long session, long model, long path, long error) {
        try { return (int) mien_model_save.invokeExact(session, model, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_get_counts = library.find("mien_model_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_get_counts(long model, long vertexCount, long scalarModes, long vectorModes, long error) {
        try { return (int) mien_model_get_counts.invokeExact(model, vertexCount, scalarModes, vectorModes, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_get_json = library.find("mien_model_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_get_json(long model, long dst, long capacity, long count, long error) {
        try { return (int) mien_model_get_json.invokeExact(model, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_get_variance = library.find("mien_model_get_variance", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_get_variance(long model, long dst, long capacity, long count, long error) {
        try { return (int) mien_model_get_variance.invokeExact(model, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_sample = library.find("mien_model_sample", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_sample(long session, long model, long seed, long index, double strength, long out, long error) {
        try { return (int) mien_model_sample.invokeExact(session, model, seed, index, strength, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_condition = library.find("mien_model_condition", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_condition(long session, long model, long observations, long observationCount, long out, long error) {
        try { return (int) mien_model_condition.invokeExact(session, model, observations, observationCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_tune_options_init = library.find("mien_tune_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_tune_options_init(long options, long structSize) {
        try { mien_tune_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_tune = library.find("mien_model_tune", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_tune(long session, long templateMesh, long dataset, long options, long out, long error) {
        try { return (int) mien_model_tune.invokeExact(session, templateMesh, dataset, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_tuning_get_json = library.find("mien_tuning_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_tuning_get_json(long tuning, long dst, long capacity, long count, long error) {
        try { return (int) mien_tuning_get_json.invokeExact(tuning, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_tuning_release = library.find("mien_tuning_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_tuning_release(long tuning) {
        try { mien_tuning_release.invokeExact(tuning); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_mesh = library.find("mien_model_mesh", FunctionDescriptor.of(JAVA_LONG, JAVA_LONG));
    @Override public long mien_model_mesh(long model) {
        try { return (long) mien_model_mesh.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_retain = library.find("mien_model_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_model_retain(long model) {
        try { mien_model_retain.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_release = library.find("mien_model_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_model_release(long model) {
        try { mien_model_release.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_load = library.find("mien_landmarks_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_load(long session, long path, long out, long error) {
        try { return (int) mien_landmarks_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_create = library.find("mien_landmarks_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_create(long landmarks, long landmarkCount, long out, long error) {
        try { return (int) mien_landmarks_create.invokeExact(landmarks, landmarkCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_get_landmarks = library.find("mien_model_get_landmarks", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_get_landmarks(long model, long out, long error) {
        try { return (int) mien_model_get_landmarks.invokeExact(model, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_match = library.find("mien_landmarks_match", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_match(long landmarks, long model, long out, long error) {
        try { return (int) mien_landmarks_match.invokeExact(landmarks, model, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_on_mesh = library.find("mien_landmarks_on_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_on_mesh(long landmarks, long mesh, long out, long error) {
        try { return (int) mien_landmarks_on_mesh.invokeExact(landmarks, mesh, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_save = library.find("mien_landmarks_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_save(long session, long landmarks, long path, long error) {
        try { return (int) mien_landmarks_save.invokeExact(session, landmarks, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_get_counts = library.find("mien_landmarks_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_get_counts(long landmarks, long count, long pickedCount, long error) {
        try { return (int) mien_landmarks_get_counts.invokeExact(landmarks, count, pickedCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_get_name = library.find("mien_landmarks_get_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_get_name(long landmarks, long index, long dst, long capacity, long count, long error) {
        try { return (int) mien_landmarks_get_name.invokeExact(landmarks, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_get_mark = library.find("mien_landmarks_get_mark", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_get_mark(long landmarks, long index, long where, long position, long vertex, long error) {
        try { return (int) mien_landmarks_get_mark.invokeExact(landmarks, index, where, position, vertex, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_get_json = library.find("mien_landmarks_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_get_json(long landmarks, long dst, long capacity, long count, long error) {
        try { return (int) mien_landmarks_get_json.invokeExact(landmarks, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_retain = library.find("mien_landmarks_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_landmarks_retain(long landmarks) {
        try { mien_landmarks_retain.invokeExact(landmarks); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_release = library.find("mien_landmarks_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_landmarks_release(long landmarks) {
        try { mien_landmarks_release.invokeExact(landmarks); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_load = library.find("mien_zones_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_load(long session, long path, long out, long error) {
        try { return (int) mien_zones_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_create = library.find("mien_zones_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_create(long zones, long zoneCount, long out, long error) {
        try { return (int) mien_zones_create.invokeExact(zones, zoneCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_get_zones = library.find("mien_model_get_zones", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_get_zones(long model, long out, long error) {
        try { return (int) mien_model_get_zones.invokeExact(model, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_save = library.find("mien_zones_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_save(long session, long zones, long path, long error) {
        try { return (int) mien_zones_save.invokeExact(session, zones, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_get_count = library.find("mien_zones_get_count", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_get_count(long zones, long count, long error) {
        try { return (int) mien_zones_get_count.invokeExact(zones, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_get_name = library.find("mien_zones_get_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_get_name(long zones, long index, long dst, long capacity, long count, long error) {
        try { return (int) mien_zones_get_name.invokeExact(zones, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_get_vertices = library.find("mien_zones_get_vertices", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_zones_get_vertices(long zones, long index, long dst, long capacity, long count, long error) {
        try { return (int) mien_zones_get_vertices.invokeExact(zones, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_retain = library.find("mien_zones_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_zones_retain(long zones) {
        try { mien_zones_retain.invokeExact(zones); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_zones_release = library.find("mien_zones_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_zones_release(long zones) {
        try { mien_zones_release.invokeExact(zones); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_options_init = library.find("mien_anthropometry_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_anthropometry_options_init(long options, long structSize) {
        try { mien_anthropometry_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_landmarks_add_profile = library.find("mien_landmarks_add_profile", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_landmarks_add_profile(long landmarks, long templateMesh, long out, long error) {
        try { return (int) mien_landmarks_add_profile.invokeExact(landmarks, templateMesh, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_anthropometry = library.find("mien_measure_anthropometry", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_anthropometry(long session, long face, long landmarks, long options, long out, long error) {
        try { return (int) mien_measure_anthropometry.invokeExact(session, face, landmarks, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_get_counts = library.find("mien_anthropometry_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_anthropometry_get_counts(long anthropometry, long count, long knownCount, long error) {
        try { return (int) mien_anthropometry_get_counts.invokeExact(anthropometry, count, knownCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_get_name = library.find("mien_anthropometry_get_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_anthropometry_get_name(long anthropometry, long index, long dst, long capacity, long count, long error) {
        try { return (int) mien_anthropometry_get_name.invokeExact(anthropometry, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_get_value = library.find("mien_anthropometry_get_value", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_anthropometry_get_value(long anthropometry, long index, long out, long error) {
        try { return (int) mien_anthropometry_get_value.invokeExact(anthropometry, index, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_get_reason = library.find("mien_anthropometry_get_reason", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_anthropometry_get_reason(long anthropometry, long index, long dst, long capacity, long count, long error) {
        try { return (int) mien_anthropometry_get_reason.invokeExact(anthropometry, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_get_json = library.find("mien_anthropometry_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_anthropometry_get_json(long anthropometry, long dst, long capacity, long count, long error) {
        try { return (int) mien_anthropometry_get_json.invokeExact(anthropometry, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_anthropometry_release = library.find("mien_anthropometry_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_anthropometry_release(long anthropometry) {
        try { mien_anthropometry_release.invokeExact(anthropometry); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_norms_create = library.find("mien_norms_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_norms_create(long session, long datasetPath, long landmarks, long options, long out, long error) {
        try { return (int) mien_norms_create.invokeExact(session, datasetPath, landmarks, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_norms_load = library.find("mien_norms_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_norms_load(long session, long path, long out, long error) {
        try { return (int) mien_norms_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_norms_save = library.find("mien_norms_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_norms_save(long session, long norms, long path, long error) {
        try { return (int) mien_norms_save.invokeExact(session, norms, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_norms_get_json = library.find("mien_norms_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_norms_get_json(long norms, long dst, long capacity, long count, long error) {
        try { return (int) mien_norms_get_json.invokeExact(norms, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_norms_release = library.find("mien_norms_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_norms_release(long norms) {
        try { mien_norms_release.invokeExact(norms); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_options_init = library.find("mien_measure_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_measure_options_init(long options, long structSize) {
        try { mien_measure_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_volume = library.find("mien_measure_volume", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_volume(long session, long before, long after, long options, long out, long error) {
        try { return (int) mien_measure_volume.invokeExact(session, before, after, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_distance = library.find("mien_measure_distance", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_distance(long session, long before, long after, long options, long out, long error) {
        try { return (int) mien_measure_distance.invokeExact(session, before, after, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_surface_distance = library.find("mien_measure_surface_distance", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_surface_distance(long session, long before, long after, long options, long out, long error) {
        try { return (int) mien_measure_surface_distance.invokeExact(session, before, after, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_closed_volume = library.find("mien_measure_closed_volume", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_closed_volume(long session, long mesh, int closeRims, long volumeMl, long error) {
        try { return (int) mien_measure_closed_volume.invokeExact(session, mesh, closeRims, volumeMl, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_area = library.find("mien_measure_area", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_area(long session, long mesh, long zone, long areaMm2, long error) {
        try { return (int) mien_measure_area.invokeExact(session, mesh, zone, areaMm2, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_curvature = library.find("mien_measure_curvature", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_curvature(long session, long mesh, double radiusMm, int robust, long options, long out, long error) {
        try { return (int) mien_measure_curvature.invokeExact(session, mesh, radiusMm, robust, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_lengths = library.find("mien_measure_lengths", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_lengths(long session, long mesh, long pairs, long pairCount, long straightMm, long geodesicMm, long error) {
        try { return (int) mien_measure_lengths.invokeExact(session, mesh, pairs, pairCount, straightMm, geodesicMm, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_scan_volume = library.find("mien_measure_scan_volume", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_scan_volume(long session, long before, long after, int carry, long direction, long options, long coverage, long out, long error) {
        try { return (int) mien_measure_scan_volume.invokeExact(session, before, after, carry, direction, options, coverage, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_align = library.find("mien_measure_align", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_align(long session, long moving, long target, long stable, long info, long out, long error) {
        try { return (int) mien_measure_align.invokeExact(session, moving, target, stable, info, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_zones = library.find("mien_measurement_get_zones", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_zones(long measurement, long zoneCount, long zonesDisjoint, long error) {
        try { return (int) mien_measurement_get_zones.invokeExact(measurement, zoneCount, zonesDisjoint, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_volume = library.find("mien_measurement_get_volume", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_volume(long measurement, int zone, long out, long error) {
        try { return (int) mien_measurement_get_volume.invokeExact(measurement, zone, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_distance = library.find("mien_measurement_get_distance", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_distance(long measurement, int zone, long out, long error) {
        try { return (int) mien_measurement_get_distance.invokeExact(measurement, zone, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_field = library.find("mien_measurement_get_field", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_field(long measurement, int field, long dst, long capacity, long count, long error) {
        try { return (int) mien_measurement_get_field.invokeExact(measurement, field, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_json = library.find("mien_measurement_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_json(long measurement, long dst, long capacity, long count, long error) {
        try { return (int) mien_measurement_get_json.invokeExact(measurement, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_release = library.find("mien_measurement_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_measurement_release(long measurement) {
        try { mien_measurement_release.invokeExact(measurement); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_asymmetry_options_init = library.find("mien_asymmetry_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_asymmetry_options_init(long options, long structSize) {
        try { mien_asymmetry_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_asymmetry = library.find("mien_measure_asymmetry", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_asymmetry(long session, long face, long templateMesh, long options, long out, long error) {
        try { return (int) mien_measure_asymmetry.invokeExact(session, face, templateMesh, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measurement_get_mirror_plane = library.find("mien_measurement_get_mirror_plane", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measurement_get_mirror_plane(long measurement, long out, long error) {
        try { return (int) mien_measurement_get_mirror_plane.invokeExact(measurement, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_register_options_init = library.find("mien_register_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_register_options_init(long options, long structSize) {
        try { mien_register_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_register = library.find("mien_register", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_register(long session, long model, long scan, long options, long out, long error) {
        try { return (int) mien_register.invokeExact(session, model, scan, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_mesh = library.find("mien_registration_mesh", FunctionDescriptor.of(JAVA_LONG, JAVA_LONG));
    @Override public long mien_registration_mesh(long registration) {
        try { return (long) mien_registration_mesh.invokeExact(registration); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_verdict = library.find("mien_registration_get_verdict", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_verdict(long registration, long out, long error) {
        try { return (int) mien_registration_get_verdict.invokeExact(registration, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_expected_error = library.find("mien_registration_get_expected_error", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_expected_error(long registration, long zone, long out, long error) {
        try { return (int) mien_registration_get_expected_error.invokeExact(registration, zone, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_field = library.find("mien_registration_get_field", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_field(long registration, int field, long dst, long capacity, long count, long error) {
        try { return (int) mien_registration_get_field.invokeExact(registration, field, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_correspondence = library.find("mien_registration_get_correspondence", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_correspondence(long registration, long triangles, long barycentric, long capacity, long count, long error) {
        try { return (int) mien_registration_get_correspondence.invokeExact(registration, triangles, barycentric, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_motion = library.find("mien_registration_get_motion", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_motion(long registration, long matrix, long error) {
        try { return (int) mien_registration_get_motion.invokeExact(registration, matrix, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_json = library.find("mien_registration_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_json(long registration, long dst, long capacity, long count, long error) {
        try { return (int) mien_registration_get_json.invokeExact(registration, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_save = library.find("mien_registration_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_save(long session, long registration, long path, long error) {
        try { return (int) mien_registration_save.invokeExact(session, registration, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_load = library.find("mien_registration_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_load(long session, long path, long out, long error) {
        try { return (int) mien_registration_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_create = library.find("mien_registration_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_create(long session, long mesh, long weight, long residual, long standardDeviation, int quality, long out, long error) {
        try { return (int) mien_registration_create.invokeExact(session, mesh, weight, residual, standardDeviation, quality, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_tie_options_init = library.find("mien_tie_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_tie_options_init(long options, long structSize) {
        try { mien_tie_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_tie = library.find("mien_registration_tie", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_tie(long session, long model, long reference, long referenceScan, long registration, long scan, long options, long out, long error) {
        try { return (int) mien_registration_tie.invokeExact(session, model, reference, referenceScan, registration, scan, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_retain = library.find("mien_registration_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_registration_retain(long registration) {
        try { mien_registration_retain.invokeExact(registration); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_release = library.find("mien_registration_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_registration_release(long registration) {
        try { mien_registration_release.invokeExact(registration); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_surface_transfer_points = library.find("mien_surface_transfer_points", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_surface_transfer_points(long session, long surface, long points, double maxDistanceMm, long triangles, long barycentric, long positions, long capacity, long count, long error) {
        try { return (int) mien_surface_transfer_points.invokeExact(session, surface, points, maxDistanceMm, triangles, barycentric, positions, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_surface_transfer_zone = library.find("mien_surface_transfer_zone", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_surface_transfer_zone(long session, long from, long vertices, long vertexCount, long to, double maxDistanceMm, long dst, long capacity, long count, long error) {
        try { return (int) mien_surface_transfer_zone.invokeExact(session, from, vertices, vertexCount, to, maxDistanceMm, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_surface_transfer_json = library.find("mien_surface_transfer_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_surface_transfer_json(long session, long model, long fitted, long scan, int what, double maxDistanceMm, long dst, long capacity, long count, long error) {
        try { return (int) mien_surface_transfer_json.invokeExact(session, model, fitted, scan, what, maxDistanceMm, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_options_init = library.find("mien_batch_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_batch_options_init(long options, long structSize) {
        try { mien_batch_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_ready_scan_create = library.find("mien_ready_scan_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_ready_scan_create(long session, long scan, long options, long out, long error) {
        try { return (int) mien_ready_scan_create.invokeExact(session, scan, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_ready_scan_register = library.find("mien_ready_scan_register", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_ready_scan_register(long session, long model, long scan, long options, long out, long error) {
        try { return (int) mien_ready_scan_register.invokeExact(session, model, scan, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_ready_scan_retain = library.find("mien_ready_scan_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_ready_scan_retain(long scan) {
        try { mien_ready_scan_retain.invokeExact(scan); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_ready_scan_release = library.find("mien_ready_scan_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_ready_scan_release(long scan) {
        try { mien_ready_scan_release.invokeExact(scan); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_create = library.find("mien_batch_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_batch_create(long session, long model, long out, long error) {
        try { return (int) mien_batch_create.invokeExact(session, model, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_add = library.find("mien_batch_add", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_batch_add(long session, long batch, long scan, long options, long error) {
        try { return (int) mien_batch_add.invokeExact(session, batch, scan, options, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_run = library.find("mien_batch_run", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_batch_run(long session, long batch, long options, long error) {
        try { return (int) mien_batch_run.invokeExact(session, batch, options, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_get_counts = library.find("mien_batch_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_batch_get_counts(long batch, long scanCount, long runCount, long error) {
        try { return (int) mien_batch_get_counts.invokeExact(batch, scanCount, runCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_get_registration = library.find("mien_batch_get_registration", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_batch_get_registration(long batch, int index, long out, long error) {
        try { return (int) mien_batch_get_registration.invokeExact(batch, index, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_retain = library.find("mien_batch_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_batch_retain(long batch) {
        try { mien_batch_retain.invokeExact(batch); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_batch_release = library.find("mien_batch_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_batch_release(long batch) {
        try { mien_batch_release.invokeExact(batch); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_options_init = library.find("mien_spectral_basis_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_spectral_basis_options_init(long options, long structSize) {
        try { mien_spectral_basis_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_build = library.find("mien_spectral_basis_build", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_build(long session, long mean, long options, long out, long error) {
        try { return (int) mien_spectral_basis_build.invokeExact(session, mean, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_load = library.find("mien_spectral_basis_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_load(long session, long path, long out, long error) {
        try { return (int) mien_spectral_basis_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_save = library.find("mien_spectral_basis_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_save(long session, long basis, long path, long error) {
        try { return (int) mien_spectral_basis_save.invokeExact(session, basis, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_get_counts = library.find("mien_spectral_basis_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_get_counts(long basis, long vertexCount, long modeCount, long error) {
        try { return (int) mien_spectral_basis_get_counts.invokeExact(basis, vertexCount, modeCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_get_eigenvalues = library.find("mien_spectral_basis_get_eigenvalues", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_get_eigenvalues(long basis, long dst, long capacity, long count, long error) {
        try { return (int) mien_spectral_basis_get_eigenvalues.invokeExact(basis, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_retain = library.find("mien_spectral_basis_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_spectral_basis_retain(long basis) {
        try { mien_spectral_basis_retain.invokeExact(basis); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_release = library.find("mien_spectral_basis_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_spectral_basis_release(long basis) {
        try { mien_spectral_basis_release.invokeExact(basis); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_split = library.find("mien_spectral_split", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_split(long session, long basis, long face, long k, long low, long high, long error) {
        try { return (int) mien_spectral_split.invokeExact(session, basis, face, k, low, high, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_assemble = library.find("mien_spectral_assemble", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_assemble(long session, long basis, long low, long high, long k, long out, long error) {
        try { return (int) mien_spectral_assemble.invokeExact(session, basis, low, high, k, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_edit = library.find("mien_spectral_edit", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_edit(long session, long basis, long face, long limits, long limitCount, long gains, long out, long error) {
        try { return (int) mien_spectral_edit.invokeExact(session, basis, face, limits, limitCount, gains, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_mix = library.find("mien_spectral_mix", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_mix(long session, long basis, long first, long second, long limits, long limitCount, long weights, long out, long error) {
        try { return (int) mien_spectral_mix.invokeExact(session, basis, first, second, limits, limitCount, weights, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_get_vector = library.find("mien_spectral_basis_get_vector", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_get_vector(long basis, long mode, long dst, long capacity, long count, long error) {
        try { return (int) mien_spectral_basis_get_vector.invokeExact(basis, mode, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_get_mass = library.find("mien_spectral_basis_get_mass", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_get_mass(long basis, long dst, long capacity, long count, long error) {
        try { return (int) mien_spectral_basis_get_mass.invokeExact(basis, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_basis_get_mean = library.find("mien_spectral_basis_get_mean", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_basis_get_mean(long basis, long out, long error) {
        try { return (int) mien_spectral_basis_get_mean.invokeExact(basis, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_project = library.find("mien_spectral_project", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_project(long session, long basis, long face, long modeCount, long dst, long capacity, long count, long error) {
        try { return (int) mien_spectral_project.invokeExact(session, basis, face, modeCount, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_spectral_synthesize = library.find("mien_spectral_synthesize", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_spectral_synthesize(long session, long basis, long coefficients, long rowCount, long firstMode, long out, long error) {
        try { return (int) mien_spectral_synthesize.invokeExact(session, basis, coefficients, rowCount, firstMode, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_metric = library.find("mien_metric", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_metric(long session, int metric, long reference, long other, long value, long error) {
        try { return (int) mien_metric.invokeExact(session, metric, reference, other, value, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_metric_field = library.find("mien_metric_field", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_metric_field(long session, int metric, long reference, long other, long dst, long capacity, long count, long error) {
        try { return (int) mien_metric_field.invokeExact(session, metric, reference, other, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_metric_roughness = library.find("mien_metric_roughness", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_metric_roughness(long session, long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_metric_roughness.invokeExact(session, mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_transfer_expression = library.find("mien_transfer_expression", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_transfer_expression(long session, long sourceNeutral, long sourceExpression, long targetNeutral, long out, long error) {
        try { return (int) mien_transfer_expression.invokeExact(session, sourceNeutral, sourceExpression, targetNeutral, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_options_init = library.find("mien_blendshape_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_blendshape_options_init(long options, long structSize) {
        try { mien_blendshape_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_train = library.find("mien_blendshape_model_train", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_train(long session, long datasetPath, long expression, long options, long out, long error) {
        try { return (int) mien_blendshape_model_train.invokeExact(session, datasetPath, expression, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_load = library.find("mien_blendshape_model_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_load(long session, long path, long out, long error) {
        try { return (int) mien_blendshape_model_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_save = library.find("mien_blendshape_model_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_save(long session, long model, long path, long error) {
        try { return (int) mien_blendshape_model_save.invokeExact(session, model, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_get_mean = library.find("mien_blendshape_model_get_mean", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_get_mean(long model, long out, long error) {
        try { return (int) mien_blendshape_model_get_mean.invokeExact(model, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_predict = library.find("mien_blendshape_model_predict", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_predict(long session, long model, long basis, long k, long neutral, long out, long error) {
        try { return (int) mien_blendshape_model_predict.invokeExact(session, model, basis, k, neutral, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_search = library.find("mien_blendshape_model_search", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_blendshape_model_search(long session, long model, long basis, long datasetPath, long expression, long candidates, int candidateCount, long options, long choices, long error) {
        try { return (int) mien_blendshape_model_search.invokeExact(session, model, basis, datasetPath, expression, candidates, candidateCount, options, choices, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_retain = library.find("mien_blendshape_model_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_blendshape_model_retain(long model) {
        try { mien_blendshape_model_retain.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_blendshape_model_release = library.find("mien_blendshape_model_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_blendshape_model_release(long model) {
        try { mien_blendshape_model_release.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_dataset_writer_create = library.find("mien_dataset_writer_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_dataset_writer_create(long session, long topology, long expressionNames, int expressionCount, long out, long error) {
        try { return (int) mien_dataset_writer_create.invokeExact(session, topology, expressionNames, expressionCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_dataset_writer_add = library.find("mien_dataset_writer_add", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG));
    @Override public int mien_dataset_writer_add(long writer, long positions, int subject, int expression, long error) {
        try { return (int) mien_dataset_writer_add.invokeExact(writer, positions, subject, expression, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_dataset_writer_save = library.find("mien_dataset_writer_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_dataset_writer_save(long session, long writer, long path, long error) {
        try { return (int) mien_dataset_writer_save.invokeExact(session, writer, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_dataset_writer_release = library.find("mien_dataset_writer_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_dataset_writer_release(long writer) {
        try { mien_dataset_writer_release.invokeExact(writer); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_load = library.find("mien_expression_model_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_load(long session, long path, long out, long error) {
        try { return (int) mien_expression_model_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_load_memory = library.find("mien_expression_model_load_memory", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_load_memory(long session, long data, long size, long out, long error) {
        try { return (int) mien_expression_model_load_memory.invokeExact(session, data, size, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_save = library.find("mien_expression_model_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_save(long session, long model, long path, long error) {
        try { return (int) mien_expression_model_save.invokeExact(session, model, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_retain = library.find("mien_expression_model_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_expression_model_retain(long model) {
        try { mien_expression_model_retain.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_release = library.find("mien_expression_model_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_expression_model_release(long model) {
        try { mien_expression_model_release.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_get_counts = library.find("mien_expression_model_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_get_counts(long model, long vertexCount, long identityModes, long expressionModes, long error) {
        try { return (int) mien_expression_model_get_counts.invokeExact(model, vertexCount, identityModes, expressionModes, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_get_json = library.find("mien_expression_model_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_get_json(long model, long dst, long capacity, long count, long error) {
        try { return (int) mien_expression_model_get_json.invokeExact(model, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_synthesize = library.find("mien_expression_model_synthesize", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_synthesize(long session, long model, long identity, long expression, long out, long error) {
        try { return (int) mien_expression_model_synthesize.invokeExact(session, model, identity, expression, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_sample = library.find("mien_expression_model_sample", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_sample(long session, long model, long seed, long expression, long out, long error) {
        try { return (int) mien_expression_model_sample.invokeExact(session, model, seed, expression, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralize_options_init = library.find("mien_neutralize_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_neutralize_options_init(long options, long structSize) {
        try { mien_neutralize_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralize = library.find("mien_neutralize", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralize(long session, long model, long fitted, long options, long out, long error) {
        try { return (int) mien_neutralize.invokeExact(session, model, fitted, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralize_mesh = library.find("mien_neutralize_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralize_mesh(long session, long model, long face, long options, long out, long error) {
        try { return (int) mien_neutralize_mesh.invokeExact(session, model, face, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_mesh = library.find("mien_neutralization_mesh", FunctionDescriptor.of(JAVA_LONG, JAVA_LONG));
    @Override public long mien_neutralization_mesh(long neutralization) {
        try { return (long) mien_neutralization_mesh.invokeExact(neutralization); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_get_counts = library.find("mien_neutralization_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_get_counts(long neutralization, long vertexCount, long identityModes, long expressionModes, long error) {
        try { return (int) mien_neutralization_get_counts.invokeExact(neutralization, vertexCount, identityModes, expressionModes, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_get_coordinates = library.find("mien_neutralization_get_coordinates", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_get_coordinates(long neutralization, long identity, long expression, long error) {
        try { return (int) mien_neutralization_get_coordinates.invokeExact(neutralization, identity, expression, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_get_uncertainty = library.find("mien_neutralization_get_uncertainty", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_get_uncertainty(long neutralization, long dst, long capacity, long count, long error) {
        try { return (int) mien_neutralization_get_uncertainty.invokeExact(neutralization, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_get_reading = library.find("mien_neutralization_get_reading", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_get_reading(long neutralization, int reading, long out, long error) {
        try { return (int) mien_neutralization_get_reading.invokeExact(neutralization, reading, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_get_json = library.find("mien_neutralization_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_get_json(long neutralization, long dst, long capacity, long count, long error) {
        try { return (int) mien_neutralization_get_json.invokeExact(neutralization, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_release = library.find("mien_neutralization_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_neutralization_release(long neutralization) {
        try { mien_neutralization_release.invokeExact(neutralization); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralization_apply_to_scan = library.find("mien_neutralization_apply_to_scan", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralization_apply_to_scan(long session, long neutralization, long scan, double maxDistanceMm, long out, long error) {
        try { return (int) mien_neutralization_apply_to_scan.invokeExact(session, neutralization, scan, maxDistanceMm, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_transfer = library.find("mien_expression_model_transfer", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_transfer(long session, long model, long source, long target, long out, long error) {
        try { return (int) mien_expression_model_transfer.invokeExact(session, model, source, target, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_evaluate_options_init = library.find("mien_evaluate_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_evaluate_options_init(long options, long structSize) {
        try { mien_evaluate_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_evaluate_neutralization = library.find("mien_evaluate_neutralization", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_evaluate_neutralization(long session, long model, long datasetPath, long options, long out, long error) {
        try { return (int) mien_evaluate_neutralization.invokeExact(session, model, datasetPath, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_evaluation_get_json = library.find("mien_evaluation_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_evaluation_get_json(long evaluation, long dst, long capacity, long count, long error) {
        try { return (int) mien_evaluation_get_json.invokeExact(evaluation, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_evaluation_release = library.find("mien_evaluation_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_evaluation_release(long evaluation) {
        try { mien_evaluation_release.invokeExact(evaluation); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follow_options_init = library.find("mien_follow_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_follow_options_init(long options, long structSize) {
        try { mien_follow_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_create = library.find("mien_follower_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_follower_create(long session, long model, long start, long options, long out, long error) {
        try { return (int) mien_follower_create.invokeExact(session, model, start, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_fit = library.find("mien_follower_fit", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_follower_fit(long session, long follower, long points, int width, int height, long out, long error) {
        try { return (int) mien_follower_fit.invokeExact(session, follower, points, width, height, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_get_mesh = library.find("mien_follower_get_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_follower_get_mesh(long follower, long out, long error) {
        try { return (int) mien_follower_get_mesh.invokeExact(follower, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_get_motion = library.find("mien_follower_get_motion", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_follower_get_motion(long follower, long matrix, long error) {
        try { return (int) mien_follower_get_motion.invokeExact(follower, matrix, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_retain = library.find("mien_follower_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_follower_retain(long follower) {
        try { mien_follower_retain.invokeExact(follower); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_follower_release = library.find("mien_follower_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_follower_release(long follower) {
        try { mien_follower_release.invokeExact(follower); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_geodesic_options_init = library.find("mien_geodesic_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_geodesic_options_init(long options, long structSize) {
        try { mien_geodesic_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_measure_geodesic = library.find("mien_measure_geodesic", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_measure_geodesic(long session, long mesh, long sources, long sourceCount, long options, long dst, long capacity, long count, long error) {
        try { return (int) mien_measure_geodesic.invokeExact(session, mesh, sources, sourceCount, options, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_build_quadric = library.find("mien_hierarchy_build_quadric", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_build_quadric(long session, long mesh, int levelCount, double factor, long out, long error) {
        try { return (int) mien_hierarchy_build_quadric.invokeExact(session, mesh, levelCount, factor, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_build_connectivity = library.find("mien_hierarchy_build_connectivity", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_build_connectivity(long session, long mesh, int levelCount, int stride, int radius, long out, long error) {
        try { return (int) mien_hierarchy_build_connectivity.invokeExact(session, mesh, levelCount, stride, radius, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_load = library.find("mien_hierarchy_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_load(long session, long path, long out, long error) {
        try { return (int) mien_hierarchy_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_save = library.find("mien_hierarchy_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_save(long session, long hierarchy, long path, long error) {
        try { return (int) mien_hierarchy_save.invokeExact(session, hierarchy, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_get_level_count = library.find("mien_hierarchy_get_level_count", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_get_level_count(long hierarchy, long levelCount, long error) {
        try { return (int) mien_hierarchy_get_level_count.invokeExact(hierarchy, levelCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_get_level = library.find("mien_hierarchy_get_level", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_get_level(long hierarchy, int level, long out, long error) {
        try { return (int) mien_hierarchy_get_level.invokeExact(hierarchy, level, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_apply = library.find("mien_hierarchy_apply", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_apply(long hierarchy, int level, int direction, long values, long rowCount, long channelCount, long dst, long capacity, long count, long error) {
        try { return (int) mien_hierarchy_apply.invokeExact(hierarchy, level, direction, values, rowCount, channelCount, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_get_map = library.find("mien_hierarchy_get_map", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_hierarchy_get_map(long hierarchy, int level, int direction, long rows, long columns, long values, long capacity, long count, long rowCount, long columnCount, long error) {
        try { return (int) mien_hierarchy_get_map.invokeExact(hierarchy, level, direction, rows, columns, values, capacity, count, rowCount, columnCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_retain = library.find("mien_hierarchy_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_hierarchy_retain(long hierarchy) {
        try { mien_hierarchy_retain.invokeExact(hierarchy); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_hierarchy_release = library.find("mien_hierarchy_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_hierarchy_release(long hierarchy) {
        try { mien_hierarchy_release.invokeExact(hierarchy); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_inspect = library.find("mien_mesh_inspect", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_inspect(long session, long mesh, long dst, long capacity, long count, long error) {
        try { return (int) mien_mesh_inspect.invokeExact(session, mesh, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_clean = library.find("mien_mesh_clean", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_clean(long session, long mesh, long minTriangles, long out, long error) {
        try { return (int) mien_mesh_clean.invokeExact(session, mesh, minTriangles, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_transform = library.find("mien_mesh_transform", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_transform(long session, long mesh, long matrix, long out, long error) {
        try { return (int) mien_mesh_transform.invokeExact(session, mesh, matrix, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_turn_over = library.find("mien_mesh_turn_over", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_turn_over(long session, long mesh, long out, long error) {
        try { return (int) mien_mesh_turn_over.invokeExact(session, mesh, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_decimate = library.find("mien_mesh_decimate", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_decimate(long session, long mesh, long vertexCount, long out, long error) {
        try { return (int) mien_mesh_decimate.invokeExact(session, mesh, vertexCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_mesh_check_same_unit = library.find("mien_mesh_check_same_unit", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_mesh_check_same_unit(long first, long second, long error) {
        try { return (int) mien_mesh_check_same_unit.invokeExact(first, second, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_fit_options_init = library.find("mien_model_fit_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_model_fit_options_init(long options, long structSize) {
        try { mien_model_fit_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_fit = library.find("mien_model_fit", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_fit(long session, long model, long target, long options, long dst, long capacity, long count, long error) {
        try { return (int) mien_model_fit.invokeExact(session, model, target, options, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_model_synthesize = library.find("mien_model_synthesize", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_model_synthesize(long session, long model, long coefficients, long coefficientCount, long out, long error) {
        try { return (int) mien_model_synthesize.invokeExact(session, model, coefficients, coefficientCount, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_registration_get_coefficients = library.find("mien_registration_get_coefficients", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_registration_get_coefficients(long session, long registration, long model, double ridgeMm2, long dst, long capacity, long count, long error) {
        try { return (int) mien_registration_get_coefficients.invokeExact(session, registration, model, ridgeMm2, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_evaluation_options_init = library.find("mien_network_evaluation_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_network_evaluation_options_init(long options, long structSize) {
        try { mien_network_evaluation_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_options_init = library.find("mien_network_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_network_options_init(long options, long structSize) {
        try { mien_network_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_load = library.find("mien_network_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_load(long session, long path, long out, long error) {
        try { return (int) mien_network_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_load_memory = library.find("mien_network_load_memory", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_load_memory(long session, long data, long size, long out, long error) {
        try { return (int) mien_network_load_memory.invokeExact(session, data, size, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_get_counts = library.find("mien_network_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_get_counts(long network, long vertexCount, long codeCount, long error) {
        try { return (int) mien_network_get_counts.invokeExact(network, vertexCount, codeCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_get_json = library.find("mien_network_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_get_json(long network, long dst, long capacity, long count, long error) {
        try { return (int) mien_network_get_json.invokeExact(network, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_get_mean = library.find("mien_network_get_mean", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_get_mean(long network, long out, long error) {
        try { return (int) mien_network_get_mean.invokeExact(network, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_encode = library.find("mien_network_encode", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_encode(long session, long network, long face, long options, long motion, long dst, long capacity, long count, long error) {
        try { return (int) mien_network_encode.invokeExact(session, network, face, options, motion, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_decode = library.find("mien_network_decode", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_decode(long session, long network, long code, long codeCount, long motion, long options, long out, long error) {
        try { return (int) mien_network_decode.invokeExact(session, network, code, codeCount, motion, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_apply = library.find("mien_network_apply", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_apply(long session, long network, long face, long options, long out, long error) {
        try { return (int) mien_network_apply.invokeExact(session, network, face, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_get_bands = library.find("mien_network_get_bands", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_get_bands(long network, long lowCodeCount, long bandLimit, long error) {
        try { return (int) mien_network_get_bands.invokeExact(network, lowCodeCount, bandLimit, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_mix = library.find("mien_network_mix", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_mix(long session, long network, long a, long b, double lowWeight, double highWeight, long options, long out, long error) {
        try { return (int) mien_network_mix.invokeExact(session, network, a, b, lowWeight, highWeight, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_sample = library.find("mien_network_sample", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_sample(long network, long seed, long number, double spread, long dst, long capacity, long count, long error) {
        try { return (int) mien_network_sample.invokeExact(network, seed, number, spread, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_evaluate = library.find("mien_network_evaluate", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_network_evaluate(long session, long network, long datasetPath, long options, long dst, long capacity, long count, long error) {
        try { return (int) mien_network_evaluate.invokeExact(session, network, datasetPath, options, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_retain = library.find("mien_network_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_network_retain(long network) {
        try { mien_network_retain.invokeExact(network); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_network_release = library.find("mien_network_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_network_release(long network) {
        try { mien_network_release.invokeExact(network); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_train = library.find("mien_representation_train", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_train(long session, long datasetPath, int kind, int neutralOnly, long out, long error) {
        try { return (int) mien_representation_train.invokeExact(session, datasetPath, kind, neutralOnly, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_options_init = library.find("mien_representation_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_representation_options_init(long options, long structSize) {
        try { mien_representation_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_train_with_options = library.find("mien_representation_train_with_options", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_train_with_options(long session, long datasetPath, int kind, long options, long out, long error) {
        try { return (int) mien_representation_train_with_options.invokeExact(session, datasetPath, kind, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_load = library.find("mien_representation_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_load(long session, long path, long out, long error) {
        try { return (int) mien_representation_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_save = library.find("mien_representation_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_save(long session, long representation, long path, long error) {
        try { return (int) mien_representation_save.invokeExact(session, representation, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_get_counts = library.find("mien_representation_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_get_counts(long representation, long vertexCount, long channelCount, long error) {
        try { return (int) mien_representation_get_counts.invokeExact(representation, vertexCount, channelCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_encode = library.find("mien_representation_encode", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_encode(long session, long representation, long face, long motion, long dst, long capacity, long count, long error) {
        try { return (int) mien_representation_encode.invokeExact(session, representation, face, motion, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_decode = library.find("mien_representation_decode", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_representation_decode(long session, long representation, long features, long rowCount, long motion, long out, long error) {
        try { return (int) mien_representation_decode.invokeExact(session, representation, features, rowCount, motion, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_retain = library.find("mien_representation_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_representation_retain(long representation) {
        try { mien_representation_retain.invokeExact(representation); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_representation_release = library.find("mien_representation_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_representation_release(long representation) {
        try { mien_representation_release.invokeExact(representation); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_options_init = library.find("mien_score_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_score_options_init(long options, long structSize) {
        try { mien_score_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_train = library.find("mien_score_model_train", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_train(long session, long datasetPath, long grades, long gradeCount, long options, long out, long error) {
        try { return (int) mien_score_model_train.invokeExact(session, datasetPath, grades, gradeCount, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_load = library.find("mien_score_model_load", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_load(long session, long path, long out, long error) {
        try { return (int) mien_score_model_load.invokeExact(session, path, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_save = library.find("mien_score_model_save", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_save(long session, long model, long path, long error) {
        try { return (int) mien_score_model_save.invokeExact(session, model, path, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_predict = library.find("mien_score_model_predict", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_predict(long session, long model, long face, long out, long error) {
        try { return (int) mien_score_model_predict.invokeExact(session, model, face, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_simulate = library.find("mien_score_model_simulate", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_DOUBLE, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_simulate(long session, long model, long face, double target, long out, long error) {
        try { return (int) mien_score_model_simulate.invokeExact(session, model, face, target, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_get_latent = library.find("mien_score_model_get_latent", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_get_latent(long model, int component, long dst, long capacity, long count, long error) {
        try { return (int) mien_score_model_get_latent.invokeExact(model, component, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_get_json = library.find("mien_score_model_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_score_model_get_json(long model, long dst, long capacity, long count, long error) {
        try { return (int) mien_score_model_get_json.invokeExact(model, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_retain = library.find("mien_score_model_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_score_model_retain(long model) {
        try { mien_score_model_retain.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_score_model_release = library.find("mien_score_model_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_score_model_release(long model) {
        try { mien_score_model_release.invokeExact(model); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_statistics_agreement = library.find("mien_statistics_agreement", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_statistics_agreement(long session, long ratings, long subjectCount, int raterCount, int gradeCount, long dst, long capacity, long count, long error) {
        try { return (int) mien_statistics_agreement.invokeExact(session, ratings, subjectCount, raterCount, gradeCount, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_statistics_repeatability = library.find("mien_statistics_repeatability", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_statistics_repeatability(long session, long values, long subjects, long valueCount, long blanks, long blankCount, long dst, long capacity, long count, long error) {
        try { return (int) mien_statistics_repeatability.invokeExact(session, values, subjects, valueCount, blanks, blankCount, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_statistics_bland_altman = library.find("mien_statistics_bland_altman", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_statistics_bland_altman(long session, long first, long second, long valueCount, long dst, long capacity, long count, long error) {
        try { return (int) mien_statistics_bland_altman.invokeExact(session, first, second, valueCount, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_series_options_init = library.find("mien_series_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_series_options_init(long options, long structSize) {
        try { mien_series_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralize_series = library.find("mien_neutralize_series", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralize_series(long session, long model, long faces, int faceCount, long options, long out, long error) {
        try { return (int) mien_neutralize_series.invokeExact(session, model, faces, faceCount, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_series_get_mesh = library.find("mien_series_get_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_series_get_mesh(long series, int index, long out, long error) {
        try { return (int) mien_series_get_mesh.invokeExact(series, index, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_series_get_json = library.find("mien_series_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_series_get_json(long series, long dst, long capacity, long count, long error) {
        try { return (int) mien_series_get_json.invokeExact(series, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_series_release = library.find("mien_series_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_series_release(long series) {
        try { mien_series_release.invokeExact(series); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_options_init = library.find("mien_study_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_study_options_init(long options, long structSize) {
        try { mien_study_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_create = library.find("mien_study_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_create(long session, long registrations, int registrationCount, long expressions, long options, long out, long error) {
        try { return (int) mien_study_create.invokeExact(session, registrations, registrationCount, expressions, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_create_from_meshes = library.find("mien_study_create_from_meshes", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_create_from_meshes(long session, long faces, int faceCount, long normalSd, long weights, long expressions, long options, long out, long error) {
        try { return (int) mien_study_create_from_meshes.invokeExact(session, faces, faceCount, normalSd, weights, expressions, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_counts = library.find("mien_study_get_counts", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_counts(long study, long visitCount, long zoneCount, long error) {
        try { return (int) mien_study_get_counts.invokeExact(study, visitCount, zoneCount, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_zone_name = library.find("mien_study_get_zone_name", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_zone_name(long study, int zone, long dst, long capacity, long count, long error) {
        try { return (int) mien_study_get_zone_name.invokeExact(study, zone, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_expression = library.find("mien_study_get_expression", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_expression(long study, int visit, long dst, long capacity, long count, long error) {
        try { return (int) mien_study_get_expression.invokeExact(study, visit, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_mesh = library.find("mien_study_get_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_mesh(long study, int visit, int frame, long out, long error) {
        try { return (int) mien_study_get_mesh.invokeExact(study, visit, frame, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_field = library.find("mien_study_get_field", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_field(long study, int visit, int field, long dst, long capacity, long count, long error) {
        try { return (int) mien_study_get_field.invokeExact(study, visit, field, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_distances = library.find("mien_study_get_distances", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_distances(long study, int first, int second, long dst, long capacity, long count, long error) {
        try { return (int) mien_study_get_distances.invokeExact(study, first, second, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_alignment = library.find("mien_study_get_alignment", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_alignment(long study, int first, int second, long out, long error) {
        try { return (int) mien_study_get_alignment.invokeExact(study, first, second, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_change = library.find("mien_study_get_change", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_change(long study, int first, int second, int zone, long out, long error) {
        try { return (int) mien_study_get_change.invokeExact(study, first, second, zone, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_get_json = library.find("mien_study_get_json", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_study_get_json(long study, long dst, long capacity, long count, long error) {
        try { return (int) mien_study_get_json.invokeExact(study, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_retain = library.find("mien_study_retain", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_study_retain(long study) {
        try { mien_study_retain.invokeExact(study); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_study_release = library.find("mien_study_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_study_release(long study) {
        try { mien_study_release.invokeExact(study); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_template_check = library.find("mien_template_check", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_template_check(long session, long templateMesh, long landmarks, int mirror, long dst, long capacity, long count, long error) {
        try { return (int) mien_template_check.invokeExact(session, templateMesh, landmarks, mirror, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_train_options_init = library.find("mien_train_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_train_options_init(long options, long structSize) {
        try { mien_train_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_train = library.find("mien_expression_model_train", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_train(long session, long datasetPath, long options, long out, long error) {
        try { return (int) mien_expression_model_train.invokeExact(session, datasetPath, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_shard_options_init = library.find("mien_shard_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_shard_options_init(long options, long structSize) {
        try { mien_shard_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_shard_create = library.find("mien_expression_shard_create", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_shard_create(long session, long datasetPath, long options, long shardPath, long error) {
        try { return (int) mien_expression_shard_create.invokeExact(session, datasetPath, options, shardPath, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_expression_model_merge = library.find("mien_expression_model_merge", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_expression_model_merge(long session, long shardPaths, int shardCount, long options, long out, long error) {
        try { return (int) mien_expression_model_merge.invokeExact(session, shardPaths, shardCount, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_visits_options_init = library.find("mien_visits_options_init", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG));
    @Override public void mien_visits_options_init(long options, long structSize) {
        try { mien_visits_options_init.invokeExact(options, structSize); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_neutralize_visits = library.find("mien_neutralize_visits", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_neutralize_visits(long session, long model, long faces, int faceCount, long options, long out, long error) {
        try { return (int) mien_neutralize_visits.invokeExact(session, model, faces, faceCount, options, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_visits_get_mesh = library.find("mien_visits_get_mesh", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG));
    @Override public int mien_visits_get_mesh(long visits, int index, long out, long error) {
        try { return (int) mien_visits_get_mesh.invokeExact(visits, index, out, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_visits_get_expression = library.find("mien_visits_get_expression", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_visits_get_expression(long visits, int index, long dst, long capacity, long count, long error) {
        try { return (int) mien_visits_get_expression.invokeExact(visits, index, dst, capacity, count, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_visits_get_removed_volume = library.find("mien_visits_get_removed_volume", FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_INT, JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
    @Override public int mien_visits_get_removed_volume(long visits, int first, int second, long zone, long removedMl, long sdMl, long error) {
        try { return (int) mien_visits_get_removed_volume.invokeExact(visits, first, second, zone, removedMl, sdMl, error); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }

    private final MethodHandle mien_visits_release = library.find("mien_visits_release", FunctionDescriptor.ofVoid(JAVA_LONG));
    @Override public void mien_visits_release(long visits) {
        try { mien_visits_release.invokeExact(visits); } catch (Throwable thrown) { throw ForeignLibrary.unexpected(thrown); }
    }
}

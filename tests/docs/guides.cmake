# What the guides say, held against headers, programs and sources.
set(python ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE})
set(guides ${CMAKE_CURRENT_LIST_DIR}/guides_test.py)
add_test(NAME docs_guides_words COMMAND ${python} ${guides} words ${PROJECT_SOURCE_DIR})
add_test(NAME docs_guides_compile COMMAND ${python} ${guides} compile ${PROJECT_SOURCE_DIR})
add_test(NAME docs_traceability COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/trace_requirements.py ${PROJECT_SOURCE_DIR} --check)
if(TARGET mien_command AND TARGET mien-demo-data AND BUILD_SHARED_LIBS AND NOT MIEN_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
    add_test(NAME docs_guides_run COMMAND ${python} ${guides} run ${PROJECT_SOURCE_DIR} $<TARGET_FILE:mien_command>
        $<TARGET_FILE:mien-demo-data> $<TARGET_FILE:mien> ${CMAKE_CURRENT_BINARY_DIR}/guides)
    set_tests_properties(docs_guides_run PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 77)
endif()

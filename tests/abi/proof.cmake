# The interface proven from outside: headers, exported names, layout, and that the gates can fail.
find_program(MIEN_SH sh)
find_program(MIEN_ABIDIFF abidiff)
find_program(MIEN_CLANG clang)

if(MIEN_SH)
    add_test(NAME abi_headers COMMAND ${MIEN_SH} ${CMAKE_CURRENT_SOURCE_DIR}/headers.sh ${PROJECT_SOURCE_DIR}/include)
endif()
if(MIEN_SH AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT MIEN_SANITIZE)
    add_test(NAME abi_symbols COMMAND ${MIEN_SH} ${CMAKE_CURRENT_SOURCE_DIR}/symbols.sh
        $<TARGET_FILE:mien> ${PROJECT_SOURCE_DIR}/abi/symbols.txt MIEN_${PROJECT_VERSION_MAJOR})
endif()
# What links it ships it: a library that grows by a tenth should be seen to.
if(MIEN_SH AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_BUILD_TYPE STREQUAL "Release" AND BUILD_SHARED_LIBS AND NOT MIEN_SANITIZE
   AND NOT mien_release_has_lines)
    add_test(NAME abi_size COMMAND ${MIEN_SH} -c
        "size=$(stat -L -c %s \"$1\") && echo \"$size bytes of 6000000\" && [ $size -le 6000000 ]" sh $<TARGET_FILE:mien>)
endif()
if(Python3_FOUND)
    set(python ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE})
    set(layout ${PROJECT_SOURCE_DIR}/abi/layout)
    set(public ${PROJECT_SOURCE_DIR}/include/mien)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|aarch64)$")
        add_test(NAME abi_layout COMMAND ${python} ${layout}/layout.py compare
            ${layout}/${CMAKE_SYSTEM_PROCESSOR}.txt ${public} ${CMAKE_C_COMPILER})
    endif()
    if(MIEN_CLANG)
        foreach(machine x86_64-linux-gnu aarch64-linux-gnu x86_64-w64-windows-gnu)
            string(REGEX REPLACE "-w64-windows-gnu" "-windows" snapshot ${machine})
            string(REGEX REPLACE "-linux-gnu" "" snapshot ${snapshot})
            add_test(NAME abi_layout_${snapshot} COMMAND ${python} ${layout}/layout.py compare
                ${layout}/${snapshot}.txt ${public} ${MIEN_CLANG} -ffreestanding --target=${machine} -DMIEN_STATIC)
        endforeach()
    endif()
    if(MIEN_ABIDIFF)
        add_test(NAME abi_baseline COMMAND ${python} ${PROJECT_SOURCE_DIR}/abi/baseline/witness.py compare
            ${PROJECT_SOURCE_DIR}/abi/baseline/mien-0.abi ${public})
    endif()
    add_test(NAME abi_planted_changes COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/planted_changes_layout.py ${PROJECT_SOURCE_DIR})
endif()

# Every function with every wrong argument; the tables are generated from the headers.
if(Python3_FOUND)
    file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/mien/*.h)
    set(tables ${CMAKE_CURRENT_BINARY_DIR}/abuse/abuse_tables.inc)
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/abuse)
    add_custom_command(OUTPUT ${tables}
        COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/generate_abuse.py ${public} ${tables}
        DEPENDS generate_abuse.py ${PROJECT_SOURCE_DIR}/abi/read_headers.py ${PROJECT_SOURCE_DIR}/abi/documentation.py ${public_headers})
    add_executable(test_abi_abuse abuse/main.cpp abuse/abuse.cpp abuse/struct_abuse.cpp abuse/fixtures.cpp
        abuse/good_values.cpp ${tables})
    target_include_directories(test_abi_abuse PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/abuse)
    target_link_libraries(test_abi_abuse PRIVATE mien_flags mien::mien)
    mien_compile_fast(test_abi_abuse)
    add_test(NAME abi_abuse COMMAND test_abi_abuse WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/abuse)
endif()

# A program of the first release, with that release's headers, on the present library.
add_executable(test_previous_release previous_release.c)
target_include_directories(test_previous_release PRIVATE ${PROJECT_SOURCE_DIR}/tests/golden/abi-0.1)
target_compile_options(test_previous_release PRIVATE -Wall -Wextra -Werror)
if(UNIX)
    target_link_libraries(test_previous_release PRIVATE m)
endif()
target_link_libraries(test_previous_release PRIVATE $<TARGET_LINKER_FILE:mien>)
add_dependencies(test_previous_release mien)
add_test(NAME abi_previous_release COMMAND test_previous_release)
# The same job where the stack ends after 256 KiB.
if(MIEN_SH AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT MIEN_SANITIZE)
    add_test(NAME abi_small_stack COMMAND ${MIEN_SH} -c "ulimit -s 256 && exec \"$1\"" sh $<TARGET_FILE:test_previous_release>)
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/small_stack)
    set_tests_properties(abi_small_stack PROPERTIES WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/small_stack)
endif()

add_executable(test_utf8_paths utf8_paths.c)
target_compile_options(test_utf8_paths PRIVATE -Wall -Wextra -Werror)
target_link_libraries(test_utf8_paths PRIVATE mien::mien)
add_test(NAME abi_utf8_paths COMMAND test_utf8_paths)

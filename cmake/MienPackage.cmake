# Prebuilt archives: `cmake/package.sh MACHINE` configures with MIEN_SELF_CONTAINED and calls cpack.
string(TOLOWER ${CMAKE_SYSTEM_NAME} system)
set(CPACK_PACKAGE_NAME mien)
set(CPACK_PACKAGE_VENDOR Mien)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_FILE_NAME mien-${PROJECT_VERSION}-${system}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CHECKSUM SHA256)
if(WIN32)
    set(CPACK_GENERATOR ZIP)
else()
    set(CPACK_GENERATOR TGZ)
endif()

install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/SECURITY.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(MIEN_SELF_CONTAINED)
    # What package.sh makes once the programs are built: the archive's own README, what is inside, the demo.
    install(FILES ${PROJECT_BINARY_DIR}/archive/README.md DESTINATION .)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/archive/sbom DESTINATION ${CMAKE_INSTALL_DATADIR})
    install(DIRECTORY ${PROJECT_BINARY_DIR}/archive/demo DESTINATION ${CMAKE_INSTALL_DATADIR}/mien)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION .)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/guides DESTINATION ${CMAKE_INSTALL_DOCDIR})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/mien/examples
        PATTERN __pycache__ EXCLUDE PATTERN slurm EXCLUDE PATTERN quickstart.sh EXCLUDE)
    # The licence files of everything that is linked in, gathered by cmake/dependencies.sh.
    install(DIRECTORY ${MIEN_DEPENDENCIES}/share/licenses/ DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/mien/dependencies)
    set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/manifest.cmake)
endif()
include(CPack)

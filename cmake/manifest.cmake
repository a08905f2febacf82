# Writes MANIFEST.txt into the archive: the SHA-256 and the path of each of its files, sorted.
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${CPACK_TEMPORARY_INSTALL_DIRECTORY}
    ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*)
list(REMOVE_ITEM files MANIFEST.txt)
list(SORT files)
set(manifest "")
foreach(file IN LISTS files)
    file(SHA256 ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${file} hash)
    string(APPEND manifest "${hash}  ${file}\n")
endforeach()
file(WRITE ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/MANIFEST.txt "${manifest}")

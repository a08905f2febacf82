# Eigen made safe against failed allocations, once for the whole library.
#
# Eigen 3.4 frees a matrix before it allocates the new size; when that throws, the destructor frees the old block a
# second time. And the constructors of a sparse matrix leak what they have when a later allocation throws. A library
# must outlive a failed allocation, so it is compiled with a copy of Eigen's headers in the build folder in which both
# are mended, in which allocations count towards the budget of the call, and in which long decompositions can be
# cancelled (base/memory_budget.hpp). Whoever links Eigen3::Eigen gets the copy, so that no two files of a program
# differ. A version of Eigen whose text is another one is refused here rather than taken as it is; base/types.hpp
# refuses the unmended headers.

get_target_property(eigen_listed Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
string(REGEX REPLACE "\\$<[A-Z_]+:|\\$<\\$<[^>]*>:|>" "" eigen_listed "${eigen_listed}")
foreach(folder ${eigen_listed} ${EIGEN3_INCLUDE_DIR} ${Eigen3_INCLUDE_DIRS})
    if(NOT MIEN_EIGEN_SOURCE AND EXISTS ${folder}/Eigen/src/Core/DenseStorage.h)
        set(MIEN_EIGEN_SOURCE ${folder})
    endif()
endforeach()
if(NOT MIEN_EIGEN_SOURCE)
    message(FATAL_ERROR "Eigen3::Eigen does not say where its headers are (looked in '${eigen_listed}')")
endif()
set(eigen_copy ${PROJECT_BINARY_DIR}/eigen)
# The mended files are written below, and only when they differ: otherwise everything would be compiled anew each time.
file(COPY ${MIEN_EIGEN_SOURCE}/Eigen DESTINATION ${eigen_copy}
    REGEX "/(Memory|DenseStorage|SparseMatrix|JacobiSVD|AmbiVector|CompressedStorage|Tridiagonalization|SelfAdjointEigenSolver|HouseholderSequence|LLT|SimplicialCholesky_impl)\\.h$" EXCLUDE)

# mien_mend(FILE COUNT OLD NEW): replaces OLD, which must occur COUNT times in the variable `text`.
function(mien_mend file count old new)
    string(REPLACE "${old}" "" without "${text}")
    string(LENGTH "${text}" length_before)
    string(LENGTH "${without}" length_after)
    string(LENGTH "${old}" length_old)
    math(EXPR expected "${length_before} - ${count} * ${length_old}")
    if(NOT length_after EQUAL expected)
        message(FATAL_ERROR "Eigen's ${file} (${MIEN_EIGEN_SOURCE}) is not the text that cmake/MienEigen.cmake "
            "mends: use Eigen 3.4.0, or look how this version behaves when an allocation fails")
    endif()
    string(REPLACE "${old}" "${new}" mended "${text}")
    set(text "${mended}" PARENT_SCOPE)
endfunction()
# Semicolons and brackets mean something in CMake's lists, so the text is only ever quoted.
function(mien_take file)
    file(READ ${MIEN_EIGEN_SOURCE}/Eigen/src/${file} text)
    set(text "${text}" PARENT_SCOPE)
endfunction()
function(mien_put file)
    file(CONFIGURE OUTPUT ${eigen_copy}/Eigen/src/${file} CONTENT "${text}" @ONLY)
endfunction()

# Dense: the old block is given back first, as before, but the matrix is empty while the new one is asked for.
set(allocate "        if (size>0) // >0 and not simply !=0 to let the compiler knows that size cannot be negative\n")
set(file Core/DenseStorage.h)
mien_take(${file})
mien_mend(${file} 1 "(m_data, m_rows*m_cols);\n${allocate}"
    "(m_data, m_rows*m_cols);\n        m_data = 0; m_rows = 0; m_cols = 0;\n${allocate}")
mien_mend(${file} 1 "(m_data, _Rows*m_cols);\n${allocate}"
    "(m_data, _Rows*m_cols);\n        m_data = 0; m_cols = 0;\n${allocate}")
mien_mend(${file} 1 "(m_data, _Cols*m_rows);\n${allocate}"
    "(m_data, _Cols*m_rows);\n        m_data = 0; m_rows = 0;\n${allocate}")
mien_mend(${file} 1 "#define EIGEN_MATRIXSTORAGE_H\n"
    "#define EIGEN_MATRIXSTORAGE_H\n#define MIEN_EIGEN_IS_MENDED  // cmake/MienEigen.cmake\n")
mien_put(${file})

# Sparse: the constructors stand on the default one, after which a throw runs the destructor.
set(nothing "m_outerSize(0), m_innerSize(0), m_outerIndex(0), m_innerNonZeros(0)")
set(file SparseCore/SparseMatrix.h)
mien_take(${file})
mien_mend(${file} 3 ": Base(), ${nothing}" ": SparseMatrix()")
mien_mend(${file} 3 ": ${nothing}" ": SparseMatrix()")
# A resize asks for the new index first, so that one that throws has changed nothing.
mien_mend(${file} 1 "      m_innerSize = IsRowMajor ? cols : rows;\n      m_data.clear();\n      if (m_outerSize != outerSize"
    "      if (m_outerSize != outerSize")
mien_mend(${file} 1 "        std::free(m_outerIndex);
        m_outerIndex = static_cast<StorageIndex*>(std::malloc((outerSize + 1) * sizeof(StorageIndex)));
        if (!m_outerIndex) internal::throw_std_bad_alloc();\n"
    "        StorageIndex* const fresh = static_cast<StorageIndex*>(std::malloc((outerSize + 1) * sizeof(StorageIndex)));
        if (!fresh) internal::throw_std_bad_alloc();
        std::free(m_outerIndex);
        m_outerIndex = fresh;\n")
mien_mend(${file} 1 "      memset(m_outerIndex, 0, (m_outerSize+1)*sizeof(StorageIndex));\n    }\n\n    /** \\internal
      * Resize the nonzero"
    "      m_innerSize = IsRowMajor ? cols : rows;
      m_data.clear();
      memset(m_outerIndex, 0, (m_outerSize+1)*sizeof(StorageIndex));\n    }\n\n    /** \\internal
      * Resize the nonzero")
# Of the two places that reserve room, a throw of this one left a matrix that only seemed uncompressed.
mien_mend(${file} 1 "        m_data.reserve(totalReserveSize);\n"
    "        EIGEN_TRY { m_data.reserve(totalReserveSize); }\n        EIGEN_CATCH(...) { std::free(m_innerNonZeros); m_innerNonZeros = 0; EIGEN_THROW; }\n")
mien_mend(${file} 1 "        m_data.resize(count);\n"
    "        EIGEN_TRY { m_data.resize(count); }\n        EIGEN_CATCH(...) { std::free(newOuterIndex); EIGEN_THROW; }\n")
mien_mend(${file} 1
    "        return; \n      m_innerNonZeros = static_cast<StorageIndex*>(std::malloc(m_outerSize * sizeof(StorageIndex)));\n"
    "        return; \n      m_innerNonZeros = static_cast<StorageIndex*>(std::malloc(m_outerSize * sizeof(StorageIndex)));\n      if (!m_innerNonZeros) internal::throw_std_bad_alloc();\n")
foreach(call malloc realloc free)
    string(REPLACE "std::${call}(" "mien::counted_${call}(" text "${text}")
endforeach()
mien_put(${file})

set(file SparseCore/AmbiVector.h)
mien_take(${file})
mien_mend(${file} 1 "      delete[] m_buffer;\n      if (size<1000)"
    "      delete[] m_buffer;\n      m_buffer = 0;\n      if (size<1000)")
mien_put(${file})

# A member that was destroyed to be made anew in its place is destroyed once more when that throws.
set(file SVD/JacobiSVD.h)
mien_take(${file})
mien_mend(${file} 6 "      m_qr.~QRType();\n      ::new (&m_qr) QRType(" "      m_qr = QRType(")
mien_put(${file})

# Every dense block and every sparse one counts towards the memory that the running call may take: those that malloc()
# aligns well enough and those that Eigen aligns by hand (32 bytes for AVX2; AddressSanitizer). Room is reserved before the
# system is asked, so that threads that ask in the same moment cannot all get the last of it.
set(file Core/util/Memory.h)
mien_take(${file})
mien_mend(${file} 1 "namespace Eigen {\n\nnamespace internal {\n\nEIGEN_DEVICE_FUNC\ninline void throw_std_bad_alloc()"
    "namespace mien {
void* counted_malloc(std::size_t bytes);
void* counted_realloc(void* block, std::size_t bytes);
void counted_free(void* block) noexcept;
void reserve_budget(std::size_t bytes);
void return_budget(std::size_t bytes) noexcept;
void check_interrupt();
}

namespace Eigen {\n\nnamespace internal {\n\nEIGEN_DEVICE_FUNC\ninline void throw_std_bad_alloc()")
mien_mend(${file} 1 "malloc(size+alignment);" "mien::counted_malloc(size+alignment);")
mien_mend(${file} 1 "    free(*(reinterpret_cast<void**>(ptr) - 1));" "    mien::counted_free(*(reinterpret_cast<void**>(ptr) - 1));")
mien_mend(${file} 1 "std::realloc(original,size+EIGEN_DEFAULT_ALIGN_BYTES);"
    "mien::counted_realloc(original,size+EIGEN_DEFAULT_ALIGN_BYTES);")
mien_mend(${file} 2 " = malloc(size);" " = mien::counted_malloc(size);")
mien_mend(${file} 2 " free(ptr);" " mien::counted_free(ptr);")
mien_mend(${file} 1 "  result = std::realloc(ptr,new_size);" "  result = mien::counted_realloc(ptr,new_size);")
mien_mend(${file} 1 "  return std::realloc(ptr, new_size);" "  return mien::counted_realloc(ptr, new_size);")
mien_put(${file})
set(file SparseCore/CompressedStorage.h)
mien_take(${file})
set(entry "Index(sizeof(Scalar) + sizeof(StorageIndex))")
mien_mend(${file} 1 "    ~CompressedStorage()\n    {\n"
    "    ~CompressedStorage()\n    {\n      mien::return_budget(std::size_t(m_allocatedSize*${entry}));\n")
# Two blocks of new[]: reserved for both, and given back when either is not to be had.
set(reserved "struct Reserved {
        explicit Reserved(std::size_t asked) : bytes(asked) { mien::reserve_budget(asked); }
        ~Reserved() { mien::return_budget(bytes); }
        std::size_t bytes;
      }")
mien_mend(${file} 1 "      eigen_internal_assert(size!=m_allocatedSize);\n"
    "      eigen_internal_assert(size!=m_allocatedSize);\n      ${reserved} reserved(std::size_t(size*${entry}));\n")
mien_mend(${file} 1 "      m_allocatedSize = size;\n"
    "      reserved.bytes = std::size_t(m_allocatedSize*${entry});  // what is given back now is the old one
      m_allocatedSize = size;\n")
# Here the new capacity was noted before its two blocks were there.
mien_mend(${file} 1 "          m_allocatedSize = 2*(m_size+1);\n" "          const Index grown = 2*(m_size+1);
          ${reserved} reserved(std::size_t(grown*${entry}));\n")
mien_mend(${file} 1 "newValues(m_allocatedSize);" "newValues(grown);")
mien_mend(${file} 1 "newIndices(m_allocatedSize);" "newIndices(grown);
          reserved.bytes = std::size_t(m_allocatedSize*${entry});
          m_allocatedSize = grown;")
mien_put(${file})

# A decomposition of a thousand rows takes a second: it looks between its steps whether the call is cancelled.
function(mien_mend_loop file loop)
    mien_take(${file})
    mien_mend(${file} 1 "${loop}" "${loop}    mien::check_interrupt();\n")
    mien_put(${file})
endfunction()
mien_mend_loop(Eigenvalues/Tridiagonalization.h "  for (Index i = 0; i<n-1; ++i)\n  {\n    Index remainingSize = n-i-1;\n    RealScalar beta;\n")
mien_mend_loop(Eigenvalues/SelfAdjointEigenSolver.h "  while (end>0)\n  {\n")
mien_mend_loop(Householder/HouseholderSequence.h "        for(Index i = 0; i < m_length; i+=blockSize)\n        {\n")
mien_mend_loop(Cholesky/LLT.h "    for (Index k=0; k<size; k+=blockSize)\n    {\n")
set(file SparseCholesky/SimplicialCholesky_impl.h)
mien_take(${file})
set(loop "    // compute nonzero pattern of kth row of L, in topological order\n")
mien_mend(${file} 1 "${loop}" "${loop}    if (k % 64 == 0) mien::check_interrupt();\n")
mien_put(${file})

set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${eigen_copy})

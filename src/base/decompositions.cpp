#include "base/decompositions.hpp"

MIEN_DECOMPOSITIONS()

// Mien for C++17: RAII classes and exceptions over the C ABI. Header-only, so it never takes part
// in the ABI: a program built with any compiler and standard library works with one libmien.
#ifndef MIEN_MIEN_HPP
#define MIEN_MIEN_HPP

#include "detail/anthropometry.hpp"
#include "detail/appearance.hpp"
#include "detail/batch.hpp"
#include "detail/core.hpp"
#include "detail/expression.hpp"
#include "detail/follow.hpp"
#include "detail/landmarks.hpp"
#include "detail/lifetime.hpp"
#include "detail/measure.hpp"
#include "detail/mesh_tools.hpp"
#include "detail/model.hpp"
#include "detail/model_fit.hpp"
#include "detail/network.hpp"
#include "detail/registration.hpp"
#include "detail/score.hpp"
#include "detail/spectral.hpp"
#include "detail/study.hpp"
#include "detail/visits.hpp"

#endif

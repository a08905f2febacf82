// A range scanner looking at a face: depth grid, triangulated, with what goes wrong in practice.
#pragma once

#include "people.hpp"

namespace mien::demo {

/// `neutral` over Anatomy::rest, `shape` over the template's vertices.
SimulatedScan simulate_scan(const Anatomy& anatomy, const std::vector<V3>& neutral,
                            const std::vector<V3>& shape, const Person& person,
                            const ScanOptions& options);

}  // namespace mien::demo

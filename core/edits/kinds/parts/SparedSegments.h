// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace core {

/// Segments that a cut leaves as they are, by label, ascending: where they were when it was made.
/// Whoever carries out a cut adds those that are protected (core/edits/engine/SparedSegments.h), so
/// that the edit names what it reads. A cut that restores spares none.
using SparedSegments = std::optional<std::vector<int>>;

} // namespace core

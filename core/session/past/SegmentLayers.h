// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/history/History.h"

#include <map>

namespace core {

/// From which sculpt layer each segment was made ("layer → segment"): the layer's id by label.
/// Listed are only segments for which that step is in effect, whose layer still exists, and which
/// no later step filled from another layer.
[[nodiscard]] std::map<int, int> layersOfSegments(const History& history, const Document& document);

} // namespace core

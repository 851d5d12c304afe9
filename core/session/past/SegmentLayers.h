// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/history/History.h"

#include <map>

namespace core {

/// Which sculpt layer a segment was made of ("layer → segment"): by label the layer's id, where
/// that step stands, the layer is still there, and no later one filled the segment from another
/// layer.
[[nodiscard]] std::map<int, int> layersOfSegments(const History& history, const Document& document);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

namespace test {

/// Returns a document with a volume of 20 × 16 × 10 voxels of 0.5 × 0.5 × 2 mm, rotated so that
/// index i runs to the patient's right (−x) and k downwards; value = 0.25 · code − 1024. It has
/// three empty segments.
[[nodiscard]] core::Document smallDocument();

} // namespace test

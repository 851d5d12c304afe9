// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

namespace test {

/// 20 × 16 × 10 voxels of 0.5 × 0.5 × 2 mm, rotated so that i runs to the right (−x) and k down;
/// value = 0.25 · code − 1024. With three empty segments.
[[nodiscard]] core::Document smallDocument();

} // namespace test

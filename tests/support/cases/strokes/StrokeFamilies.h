// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "tests/support/cases/strokes/StrokeScene.h"

namespace test {

// Each adds the cases of a family of edits, on what others left.

/// Segments, seeds, growth, shrinking, intervals, barriers.
void addGrowthStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
void addDrillStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// Painting, erasing, growing from seeds.
void addPaintStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// Brush, peel, scissors, laser, and drills among them.
void addCarvingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// Segments and layers as lists, what goes from one to the other, masks that come in.
void addDocumentStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// @param grown edits that leave two segments beside each other
void addChunkStrokes(std::vector<StrokeCase>& cases, const core::LoadedVolume& volume,
    const std::vector<core::Edit>& grown);
/// Pieces, protected segments, measurements.
void addPieceStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);

} // namespace test

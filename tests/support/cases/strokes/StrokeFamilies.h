// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "tests/support/cases/strokes/StrokeScene.h"

namespace test {

// Each function adds the cases of a family of edits, after edits of other families.

/// Segments, seeds, growth, shrinking, intervals, barriers.
void addGrowthStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
void addDrillStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// Painting, erasing, growing from seeds.
void addPaintStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// Carve brush, peel, scissors, laser, with drills among them.
void addCarvingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// The lists of segments and layers, conversions between them, imported masks.
void addDocumentStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// What fills a segment from what is drawn or clicked.
void addFillingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);
/// @param grown edits that result in two adjacent segments
void addChunkStrokes(std::vector<StrokeCase>& cases, const core::LoadedVolume& volume,
    const std::vector<core::Edit>& grown);
/// Pieces, protected segments, measurements.
void addPieceStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene);

} // namespace test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/kinds/Edit.h"

#include <vector>

namespace core {

/// Which bricks the result of a row depends on, those it wrote included: what "undo only here" must
/// leave as they were when the row was carried out. Rather too many than too few.
///
/// - a seed stroke: the seed words of the bricks that its points lie in;
/// - a growth: every seed word of its plane, since a burst goes on from all members, wherever they
///   are; and the labels (with "only visible" the coverage too) of the voxels it asked, which are
///   members and their neighbours: RowTrace::grownBeside. What its other limits ask is grey values;
/// - growths that take back, plug or show something first: every seed word and label of the plane;
/// - a segment that was deleted: likewise, since its label must not come back without it;
/// - a drill stroke: the coverage that its rays can meet, what the blur brings there included (seed
/// A §4.2):
///   all layers, muted or not, from the volume's front down to where the deepest cut could end
///   that begins on the deepest surface met (RowTrace::searchedTo), under the swept mask;
/// - a laser: likewise, and as far as its beams reach sideways;
/// - a peel, scissors: likewise, under a disc around the curve;
/// - paint: the labels and seed words of the bricks under the brush;
/// - a carve brush: the coverage of its own layer in the bricks under the brush;
/// - of all of these that spare segments, the labels of the same bricks too;
/// - a mask that came in: the labels and seed words of the bricks that it has voxels in;
/// - a layer that became a segment: the coverage of that layer, and the labels and seed words of
/// the
///   segment's plane, since what other segments held decided too;
/// - "segment what I see": the same, and the coverage of every layer;
/// - a segment that became a layer: the labels and seed words of its plane, and the layer's
/// coverage;
/// - layers that were merged or deleted: all of their coverage;
/// - "undo only": the bricks of the rows that it took back;
/// - a revised stroke: the bricks that it wrote. (It also folds in what lay hidden there, which
///   RevertOperation looks after.)
class RowReach {
public:
    /// @param written the bricks that the row changed; looked at for RevertRows and ReviseStroke
    /// only
    RowReach(const Edit& edit, const Document& document, const std::vector<BrickKey>& written,
        const RowTrace& trace = {});

    [[nodiscard]] bool covers(const BrickKey& key) const;

private:
    EditReach m_reach;
};

} // namespace core

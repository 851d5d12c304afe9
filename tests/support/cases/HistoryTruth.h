// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "core/volume/Volume.h"

#include <QString>

#include <map>
#include <set>
#include <variant>
#include <vector>

namespace test {

/// The expected state of a session after each row of its history, computed without using any part
/// of the session: voxels by an oracle that receives one edit at a time, "undo only" by repeating
/// all other edits, revised strokes by composing the cuts of all strokes, the document by a few
/// lines.
class HistoryTruth {
public:
    explicit HistoryTruth(core::LoadedVolume study);

    /// Adds a row that was carried out; its parent was added before.
    void add(const core::HistoryRow& row);
    /// The difference between the expected state at a row and a session that is at this row; empty
    /// if there is none.
    [[nodiscard]] QString difference(core::RowId row, core::EditEngine& engine,
        const core::Document& document, const QByteArray& stateHash) const;

    /// The document at a row, for choosing the next edit.
    [[nodiscard]] const core::Document& documentAt(core::RowId row) const;
    /// The voxels that growths have added.
    [[nodiscard]] std::vector<glm::ivec3> grownVoxels(core::RowId row, int plane) const;
    /// The labels of the whole volume in one label plane, x fastest.
    [[nodiscard]] std::vector<std::uint8_t> labelsAt(core::RowId row, int plane) const;
    /// The rows that changed voxels and are in effect at a row, ascending.
    [[nodiscard]] std::vector<core::RowId> standingAt(core::RowId row) const;

private:
    /// Bricks that are not empty.
    using Bricks = std::map<core::BrickKey, std::vector<std::uint8_t>>;
    using Cut = std::map<std::uint32_t, std::vector<std::uint8_t>>;
    struct State {
        Bricks bricks;
        core::Document document;
    };
    struct Stroke {
        core::RowId row = 0;
        core::SculptEdit form;
        bool removed = false;
    };

    [[nodiscard]] static core::SculptEdit formAfter(
        const core::Edit& drawn, const core::ReviseStroke& revise);
    [[nodiscard]] std::vector<core::RowId> path(core::RowId row) const;
    [[nodiscard]] std::set<core::RowId> standing(core::RowId row) const;
    void toggle(core::RowId row, bool stands, std::set<core::RowId>& rows) const;
    /// The bricks of segments at a row, by repeating, one after the other, the seeds, growths,
    /// strokes of paint, deletions and conversions from layers that are in effect.
    [[nodiscard]] Bricks regrown(core::RowId row) const;
    [[nodiscard]] Bricks carvedUntil(core::RowId row);
    /// Carries out an edit that writes layers other than by a cut.
    /// @param at the row whose labels it uses
    void writeLayer(const core::Edit& edit, core::RowId at, Bricks& carved) const;
    [[nodiscard]] Cut cutOf(const Stroke& stroke);
    void changeDocument(const core::Edit& edit, core::Document& document) const;
    /// The result of an edit on bricks, computed by an oracle of its own.
    [[nodiscard]] Bricks after(const Bricks& before, const core::EngineEdit& edit,
        const std::vector<core::EngineExtension>& extensions, std::uint32_t* generation,
        const core::Document* muting = nullptr) const;
    [[nodiscard]] Bricks grown(const Bricks& before, const core::Edit& edit, core::RowId parent,
        std::uint32_t* generation) const;
    [[nodiscard]] std::vector<std::uint8_t> labelsOf(const Bricks& bricks, int plane) const;
    /// The labels of the plane in which a segment of the document lies.
    [[nodiscard]] std::vector<std::uint8_t> labelsBeside(
        int segment, const Bricks& bricks, const core::Document& document) const;
    [[nodiscard]] Bricks cleaned(
        const Bricks& before, const core::CleanSegment& edit, const core::Document& document) const;
    [[nodiscard]] Bricks smoothedTogether(const Bricks& before, const core::ReshapeSegment& edit,
        const core::Document& document) const;
    [[nodiscard]] Bricks filledBetween(const Bricks& before, const core::FillBetweenSlices& edit,
        const core::Document& document) const;
    [[nodiscard]] Bricks flooded(
        const Bricks& before, const core::FloodFill& edit, const core::Document& document) const;
    [[nodiscard]] Bricks islandsSplit(
        Bricks before, const core::SplitIslands& edit, const core::Document& document) const;
    [[nodiscard]] Bricks splitByPlane(
        const Bricks& before, const core::SplitSegment& edit, const core::Document& document) const;
    [[nodiscard]] Bricks copied(
        const Bricks& before, const core::CopySegment& edit, const core::Document& document) const;
    [[nodiscard]] Bricks splitByCurve(
        const Bricks& before, const core::SplitByCurve& edit, const core::Document& document) const;
    [[nodiscard]] Bricks evolved(const Bricks& before, const core::EvolveContour& edit,
        const core::Document& document) const;
    /// Returns the bricks after a label was given to voxels of the whole volume, or taken from
    /// them.
    /// @param like an edit without bricks, which tells the target and which labels may change
    /// @param meant the voxels, x fastest
    /// @param asked RelabelListed::give or take
    [[nodiscard]] Bricks relabelled(const Bricks& before, core::RelabelListed like,
        const std::vector<bool>& meant, std::uint8_t asked) const;

    core::LoadedVolume m_study;
    int m_planes = 1; ///< number of label planes that any row has used
    std::map<core::RowId, core::HistoryRow> m_rows;
    std::map<core::RowId, State> m_states;
    std::map<QByteArray, Cut> m_cuts; ///< by row and form
};

} // namespace test

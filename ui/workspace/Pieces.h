// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/document/Piece.h"
#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"
#include "gpu/scene/Scene.h"
#include "ui/geometry/PieceExtent.h"

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// How a piece looks in the 3D view. Not a step of undo; kept with the session.
struct PieceLook {
    bool visible = true;
    double opacity = 1.0;
    /// Its own colour; if none, it is untinted, or has the segment's colour if it is a segment's
    /// piece.
    std::optional<std::uint32_t> rgb{};
    /// For a segment's piece: shows its grey values instead of a body in its colour.
    bool tissue = false;
    gpu::TransferFunction map{}; ///< its own transfer function; empty: that of the rest
    bool operator==(const PieceLook&) const = default;
};

/// The document's pieces as the window works with them: their looks, the active one, the pose
/// during a drag, and the operations on them. Part of Workspace.
class Pieces : public QObject {
    Q_OBJECT

public:
    explicit Pieces(Workspace& workspace);

    [[nodiscard]] const std::map<int, PieceLook>& looks() const { return m_looks; }
    [[nodiscard]] PieceLook look(int piece) const;
    void setLook(int piece, const PieceLook& look);
    [[nodiscard]] int active() const { return m_active; } ///< 0: none
    void setActive(int piece);

    /// The pose that is shown: that of a drag, or the document's.
    [[nodiscard]] core::PiecePose pose(const core::Piece& piece) const;
    /// Shows a pose during a drag; letGo() writes it to the document.
    void hold(int piece, const core::PiecePose& pose);
    /// Ends a drag, as a step of undo.
    /// @param keep false: restores the pose from before
    void letGo(bool keep = true);
    /// Changes the pose as a step of undo.
    void setPose(int piece, const core::PiecePose& pose);
    void sendHome();
    [[nodiscard]] bool allHome() const;
    /// Whether a piece's extent is being computed; a step may follow.
    [[nodiscard]] bool isMeasuring() const { return m_measuring.busy(); }

    /// Makes what a layer has carved a piece that turns about its middle, and a new layer the
    /// active one. The step is made when the engine has reported the extent.
    void lift(int layer);
    /// Lifts the last cut of a layer, or the whole layer if lastCut() is 0. An open peel is kept
    /// first and counts as a cut.
    void liftLast(int layer);
    /// Makes what one cut has carved a piece, even if its layer holds other cuts: the cut is moved
    /// to a new layer, which the piece takes. The layer that tools carve stays the same. If a step
    /// on the way is refused, everything before it is undone.
    /// @param cut a stroke that is part of the present state and carves
    void liftCut(core::RowId cut);
    /// The last cut of a layer, if the layer also holds others and the cut can be separated from
    /// them: nothing was restored in the layer since, and only strokes have written it. Otherwise
    /// 0.
    [[nodiscard]] core::RowId lastCut(int layer) const;
    /// Whether liftCut() is possible.
    [[nodiscard]] bool canLift(core::RowId cut) const;
    /// Shows a segment as a piece beside the volume, on the patient's left.
    void paste(int segment);
    void remove(int piece);
    /// Turns it outwards about the edge of its cut that is highest in the view.
    void openLikeALid(int piece, const glm::dvec3& upLps);

    [[nodiscard]] std::vector<gpu::ScenePiece> scene() const;
    /// "42 mm · 30° · 1.5×": how far it is from its true place; empty if it is there.
    [[nodiscard]] static QString badge(const core::PiecePose& pose);

Q_SIGNALS:
    void looksChanged(); ///< looks, or the pose of a drag
    void activeChanged();

private:
    /// Measures an extent in the background.
    /// @param then called with the extent
    /// @param unless called instead if it fails or there are no voxels; the user was told the
    /// reason
    void measure(int layer, int segment, std::function<void(const PieceExtent&)> then,
        std::function<void()> unless = {});
    /// Makes a layer a piece that rotates about its centre.
    /// @param then called when the step is made
    /// @param unless called if it cannot be made; the user was told the reason
    void cutPiece(int layer, const QString& name, std::function<void()> then,
        std::function<void()> unless = {});
    /// Takes back the layer that was added for a lift, and the cut that was moved there, once all
    /// waiting work is done.
    void withdraw(int layer);
    void apply(const core::ChangePiece& edit);
    void follow();

    Workspace& m_workspace;
    std::map<int, PieceLook> m_looks;
    int m_active = 0;
    int m_held = 0;
    core::PiecePose m_heldPose;
    core::Background m_measuring; ///< last: its results are delivered to all of the above
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/document/Piece.h"
#include "core/edits/kinds/Edit.h"
#include "gpu/scene/Scene.h"

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// How a piece looks in the 3D view; no step of undo, kept with the session.
struct PieceLook {
    bool visible = true;
    double opacity = 1.0;
    /// Its own colour; none: untinted, and of a segment's piece the segment's.
    std::optional<std::uint32_t> rgb{};
    /// Of a segment's piece: its grey values are shown, not its body in its colour.
    bool tissue = false;
    gpu::TransferFunction map{}; ///< its own in volume rendering; empty: that of the rest
    bool operator==(const PieceLook&) const = default;
};

/// The document's pieces as the window works with them: looks, the active one, a pose under the
/// hand; and what can be done to them. Part of Workspace.
class Pieces : public QObject {
    Q_OBJECT

public:
    explicit Pieces(Workspace& workspace);

    [[nodiscard]] const std::map<int, PieceLook>& looks() const { return m_looks; }
    [[nodiscard]] PieceLook look(int piece) const;
    void setLook(int piece, const PieceLook& look);
    [[nodiscard]] int active() const { return m_active; } ///< 0: none
    void setActive(int piece);

    /// The pose that is shown: that under the hand, or the document's.
    [[nodiscard]] core::PiecePose pose(const core::Piece& piece) const;
    /// Shows a pose; the document follows when it is kept.
    void hold(int piece, const core::PiecePose& pose);
    /// What is held becomes a step of undo. @param keep false: it goes back
    void letGo(bool keep = true);
    /// A step of undo at once.
    void setPose(int piece, const core::PiecePose& pose);
    void sendHome();
    [[nodiscard]] bool allHome() const;
    /// Where a piece lies is being worked out; a step may follow.
    [[nodiscard]] bool isMeasuring() const { return m_measuring.busy(); }

    /// What a layer has carved becomes a piece that turns about its middle, and a fresh layer the
    /// active one. The step comes when the engine has told where it lies.
    void lift(int layer);
    /// Shows a segment as a piece beside the volume, on the patient's left.
    void paste(int segment);
    void remove(int piece);
    /// Turns it about the edge of its cut that lies highest in the view, outwards.
    void openLikeALid(int piece, const glm::dvec3& upLps);

    [[nodiscard]] std::vector<gpu::ScenePiece> scene() const;
    /// "42 mm · 30° · 1.5×"; empty: at home.
    [[nodiscard]] static QString badge(const core::PiecePose& pose);

Q_SIGNALS:
    void looksChanged(); ///< looks, or the pose under the hand
    void activeChanged();

private:
    /// Where a piece's voxels lie.
    struct Extent {
        std::vector<glm::dvec3> pointsLps; ///< some of them, evenly
        glm::dvec3 middleLps{0.0}; ///< of their box
        glm::dvec3 sizeLps{0.0};
    };
    /// Asks the engine; @p then is not called where there is nothing.
    void measure(int layer, int segment, std::function<void(const Extent&)> then);
    [[nodiscard]] static Extent extentOf(const std::vector<core::BrickImage>& bricks,
        const core::VolumeGeometry& geometry, int segment);
    void apply(const core::ChangePiece& edit);
    void follow();

    Workspace& m_workspace;
    std::map<int, PieceLook> m_looks;
    int m_active = 0;
    int m_held = 0;
    core::PiecePose m_heldPose;
    core::Background m_measuring; ///< last: what it tells comes back to all of the above
};

} // namespace ui

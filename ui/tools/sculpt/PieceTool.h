// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Piece.h"
#include "ui/input/Tool.h"

#include <optional>

namespace ui {

class Workspace;

/// Moves and turns pieces by handles in the 3D view: dragging the middle of a piece moves it in the
/// plane of the picture; for the active piece the ring turns it in that plane, and the knobs on the
/// ring tilt it. Each drag is one step of undo; beside the handles the view navigates.
class PieceTool : public Tool {
    Q_OBJECT

public:
    explicit PieceTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;
    [[nodiscard]] bool takes(const PointerSample& sample, const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    /// Ctrl + Shift + wheel: changes the zoom of the active piece.
    void changeDepth(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    static constexpr double ringPixels = 54.0;

private:
    enum class Part { Middle, Ring, TipRight, TipUp };
    struct Handle {
        int piece = 0;
        Part part = Part::Middle;
        QPointF pixel;
        bool operator==(const Handle& other) const
        {
            return piece == other.piece && part == other.part;
        }
    };
    struct Drag {
        Handle handle;
        QPointF from;
        QPointF middle;
        core::PiecePose before;
    };
    [[nodiscard]] QPointF middleOf(const core::Piece& piece, const ViewContext& view) const;
    [[nodiscard]] std::optional<Handle> handleAt(
        const QPointF& pixel, const ViewContext& view) const;
    [[nodiscard]] core::PiecePose turned(
        const core::PiecePose& before, const glm::dvec3& axisLps, double degrees) const;

    Workspace& m_workspace;
    std::optional<Drag> m_drag;
    std::optional<Handle> m_hovered;
    QPointF m_cursor;
};

} // namespace ui

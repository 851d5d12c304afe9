// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"
#include "ui/tools/common/OutlineTool.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace ui {

/// Removes a shell from the surface inside a sketched curve (seed A §4.4). When the curve is closed
/// the peel is shown at once and stands open. A second drag sets its depth, downwards for a deeper
/// peel and upwards for a shallower one, and keeps it when the pen is lifted. Slider, keys and
/// wheel change the depth as well, until Enter or a click keeps the peel or cancel() takes it back.
/// If anything else is done first, the peel is kept, and the user is told.
class PeelTool : public OutlineTool {
    Q_OBJECT

public:
    static constexpr double minimumDepthMm = 0.5;
    static constexpr double maximumDepthMm = 60.0;
    static constexpr double maximumJumpMm = 20.0;
    /// What a drag changes per pixel at most; less where the view shows less per pixel.
    static constexpr double mostMmPerPixel = 0.2;

    [[nodiscard]] static double usualJumpMm();

    /// What counts as one surface, and where a peel ends.
    struct Gaps {
        bool through = false; ///< goes on behind gaps
        /// A step of the surface by more than this separates surfaces; 0: none does.
        double jumpMm = usualJumpMm();
        bool operator==(const Gaps&) const = default;
    };

    explicit PeelTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void putAway() override;
    void changeDepth(int steps) override;
    /// The keys [ and ]: a peel has no radius, but a depth.
    void changeRadius(int steps) override { changeDepth(steps); }
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] double depthMm() const { return m_depthMm; }
    void setDepthMm(double depthMm);
    [[nodiscard]] const Gaps& gaps() const { return m_gaps; }
    /// Also changes a peel that is open, which keeps its curve and depth.
    void setGaps(const Gaps& gaps);
    /// Whether a peel waits to be kept.
    [[nodiscard]] bool isOpen() const { return m_open; }
    void confirm();

Q_SIGNALS:
    void changed();

protected:
    void cut(const Sketch& sketch) override;
    [[nodiscard]] bool showsTaken() const override { return !m_open; }
    [[nodiscard]] SurfacePatch taken(SurfacePatch surface) const override;
    [[nodiscard]] QStringList lines() const override;

private:
    struct DepthDrag {
        QPointF from;
        double fromMm = 0.0; ///< the depth at the press
        double mmPerPixel = 0.0;
        gpu::ViewId view = 0;
    };
    [[nodiscard]] bool open(core::PeelCut peel);
    void close(core::Ending ending);
    void follow();
    /// Once it is known, calls @p report with the row that the last closed peel has become, or says
    /// that it has become none.
    void reportKept(const std::function<void(const core::HistoryRow&)>& report);
    /// Says that a peel became no row, unless something has failed since it was begun.
    /// @param failures the number of failures when it was begun
    void sayNothingWasCut(int failures, bool restores);
    void awaitEndByOther();
    void offerToTakeBack();
    void offerToTakeBack(core::RowId row);
    /// The row that a peel has become; 0: none yet.
    /// @param rowsBefore number of rows of the history when the peel was begun
    [[nodiscard]] core::RowId keptRow(std::size_t rowsBefore) const;
    [[nodiscard]] static QString keptText(const core::HistoryRow& row);

    double m_depthMm = 4.0;
    Gaps m_gaps;
    bool m_open = false;
    core::Edit m_peel; ///< the open one, a PeelCut
    std::optional<DepthDrag> m_depthDrag;
    std::size_t m_rowsBefore = 0; ///< of the history, when the peel was begun
    int m_failures = 0; ///< number of failures that the workspace has reported so far
    int m_failuresBefore = 0; ///< when the peel was begun
    bool m_wasPutAway = false; ///< the tool was just put away; false again at the next event
    /// another edit has ended the peel, and its row, or that it has none, is not known yet
    bool m_endedByOther = false;
};

} // namespace ui

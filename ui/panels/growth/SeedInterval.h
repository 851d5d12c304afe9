// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SketchInterval.h"

#include <QTimer>
#include <QWidget>

#include <glm/glm.hpp>

#include <optional>
#include <utility>
#include <vector>

class QHBoxLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace ui {

class SegmentIntervals;
class SketchLook;
class Workspace;

/// Returns the interval of values that the 3D view shows; used where no other interval is known.
[[nodiscard]] std::pair<double, double> shownValues(const Workspace& workspace);

/// The tolerance of a growth, from tight to loose: it sets the interval around what was sketched
/// for the active segment (core/growth/SketchInterval.h). After a sketch for a segment that has no
/// voxels the interval is set by itself, unless the user has set it for that segment. Each segment
/// keeps its own interval and tolerance (SegmentIntervals). It also knows the values under the
/// seeds.
///
/// While the slider is held only the interval is shown; it counts as changed once, when the slider
/// is released, or a moment after the last of several steps by keys.
class SeedInterval : public QWidget {
    Q_OBJECT

public:
    explicit SeedInterval(Workspace& workspace, QWidget* parent = nullptr);

    /// Asks the engine for the values if seeds have been added or removed.
    void ask();
    /// Shows the interval of the active segment if undo or redo has brought back another one.
    void followHistory();
    /// To be called when another session is opened.
    void forget();
    /// Puts a button beside the one that uses the seeds.
    void addButton(QWidget* button);
    /// Hides the slider while another control of the tolerance stands in its place. A drag of it
    /// that is under way ends as if it were released.
    void setReplaced(bool replaced);
    /// The values under the seeds, in modality units.
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    /// Whether the values are being looked up, after which the interval may follow them.
    [[nodiscard]] bool isLooking() const { return !m_voxels.empty() && m_values.empty(); }
    /// "12 seed voxels · 41.0 ± 3.2 HU" for the active segment. If it has no seeds the text says
    /// that there are @p seeds of others.
    [[nodiscard]] QString text(int seeds) const;
    /// The label that says, with a link, that most seeds lie outside the interval. The caller puts
    /// it into a layout.
    [[nodiscard]] QLabel* note() const { return m_note; }
    /// Shows or hides the label. @p wanted false: hidden in any case; true: shown while it has
    /// something to say.
    void showNote(bool wanted);
    /// Sets the interval in the growth's settings, not as one that the user has chosen.
    void show(std::pair<double, double> interval);
    /// Whether the active segment has voxels, so that a new interval changes a growth.
    [[nodiscard]] bool hasGrown() const;

public Q_SLOTS:
    /// Sets the interval by the seeds and the tolerance.
    void use();
Q_SIGNALS:
    void valuesChanged();
    /// The user has changed the interval in the growth's settings.
    void intervalTaken();

private:
    void build();
    void switchSegment();
    void followSettings();
    void take(const core::SketchedCodes& sketched, const std::vector<int>& seeds);
    bool takeOffered();
    void moveTolerance();
    void placeTolerance();
    [[nodiscard]] SegmentIntervals& intervals() const;
    [[nodiscard]] std::vector<core::SeedSketch> sketches() const;
    [[nodiscard]] bool maySetItself() const;
    [[nodiscard]] bool isFresh() const; ///< the segment has no voxels yet
    [[nodiscard]] std::optional<std::pair<double, double>> offered() const;
    void showState();

    Workspace& m_workspace;
    QToolButton* m_use = nullptr;
    QHBoxLayout* m_buttons = nullptr;
    QWidget* m_sliderRow = nullptr;
    QSlider* m_tolerance = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_note = nullptr;
    SketchLook* m_look = nullptr;
    QTimer m_taken; ///< joins several quick steps into one change
    std::vector<glm::ivec3> m_voxels; ///< the seeds about whose values was asked last
    int m_asked = 0; ///< label of the segment of these seeds; 0: nothing was asked
    bool m_sketchedAnew = false; ///< the question before was about the same segment
    std::vector<double> m_values; ///< the values at m_voxels
    std::optional<core::SketchedCodes> m_sketched;
    int m_segment = 0; ///< the active segment's label
    std::pair<double, double> m_last; ///< the interval in the settings
    bool m_setting = false;
};

} // namespace ui

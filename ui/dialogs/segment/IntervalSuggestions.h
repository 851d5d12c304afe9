// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QMenu;
class QToolButton;

namespace ui {

class Workspace;

/// Buttons that suggest an interval of values: Otsu's parts of the histogram, what a CT usually
/// shows, and what is clicked on in slices.
class IntervalSuggestions : public QWidget {
    Q_OBJECT

public:
    using Interval = std::pair<double, double>; ///< modality units, inclusive

    explicit IntervalSuggestions(Workspace& workspace, QWidget* parent = nullptr);

    /// What a new study begins with: a CT is mostly asked for bone, all else for what is brighter
    /// than the rest.
    [[nodiscard]] Interval first() const;
    void stopPicking();

Q_SIGNALS:
    void suggested(double lower, double upper); ///< within the volume's values

private:
    [[nodiscard]] QToolButton* menuButton(const char* name, const QString& text, const QString& tip,
        const std::function<void(QMenu&)>& fill);
    [[nodiscard]] bool isCt() const;
    void suggest(const Interval& interval);
    /// The parts into which thresholds part the histogram; they share no value. Empty: it has none.
    [[nodiscard]] std::vector<Interval> parts(int thresholds) const;
    void offerParts(QMenu& menu, int thresholds);
    void offerTissues(QMenu& menu);
    void pick(bool on);
    void pickAtCrosshair();

    Workspace& m_workspace;
    QToolButton* m_tissues = nullptr;
    QToolButton* m_pick = nullptr;
    std::optional<Interval> m_picked; ///< since picking began
};

} // namespace ui

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

/// A row of buttons that suggest an interval of values: one of the classes into which Otsu's method
/// divides the histogram, a usual interval of a CT, or the values that the user clicks on in
/// slices. A click takes the values of the voxel and its 26 neighbours; each further click widens
/// the interval.
class IntervalSuggestions : public QWidget {
    Q_OBJECT

public:
    using Interval = std::pair<double, double>; ///< modality units, inclusive

    explicit IntervalSuggestions(Workspace& workspace, QWidget* parent = nullptr);

    /// The interval to start with in a new study: bone in a CT, otherwise the brighter of Otsu's
    /// two classes.
    [[nodiscard]] Interval first() const;
    /// Ends picking by clicks on slices.
    void stopPicking();

Q_SIGNALS:
    void suggested(double lower, double upper); ///< clamped to the volume's range of values

private:
    [[nodiscard]] QToolButton* menuButton(const char* name, const QString& text, const QString& tip,
        const std::function<void(QMenu&)>& fill);
    [[nodiscard]] bool isCt() const;
    void suggest(const Interval& interval);
    /// The classes into which Otsu's thresholds divide the histogram, from the lowest up; they
    /// share no value. Empty if all values are alike.
    [[nodiscard]] std::vector<Interval> parts(int thresholds) const;
    void offerParts(QMenu& menu, int thresholds);
    void offerTissues(QMenu& menu);
    void pick(bool on);
    void pickAtCrosshair();

    Workspace& m_workspace;
    QToolButton* m_tissues = nullptr;
    QToolButton* m_pick = nullptr;
    std::optional<Interval> m_picked; ///< the values that were clicked on since picking began
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/PacsQuery.h"

#include <QTreeWidget>

#include <functional>
#include <optional>
#include <vector>

namespace ui {

/// The result of a search at a source: studies, which can be expanded to their series; series are
/// requested on expansion. The newest studies come first; a click on a column header sorts the
/// studies by it, while series keep the source's order.
class HitsTree : public QTreeWidget {
    Q_OBJECT

public:
    /// A study, or one series of it.
    struct Choice {
        core::StudyHit study;
        std::optional<core::SeriesHit> series;

        [[nodiscard]] QString seriesUid() const { return series ? series->seriesUid : QString(); }
    };
    explicit HitsTree(QWidget* parent = nullptr);

    void showStudies(const std::vector<core::StudyHit>& studies);
    void showSeries(const QString& studyUid, const std::vector<core::SeriesHit>& series);
    /// Shows a sentence in place of series that could not be obtained.
    void showTrouble(const QString& studyUid, const QString& sentence);
    /// Marks what has been downloaded already.
    /// @param isHere called for each row
    void markHere(const std::function<bool(const Choice&)>& isHere);
    [[nodiscard]] std::optional<Choice> chosen() const;

Q_SIGNALS:
    /// A study was expanded whose series are not known yet.
    void seriesRequested(const QString& studyUid);
    void choiceChanged();
    void openRequested();

private:
    [[nodiscard]] std::optional<Choice> choiceOf(const QTreeWidgetItem* item) const;
    [[nodiscard]] QTreeWidgetItem* rowOf(const QString& studyUid) const;

    std::vector<core::StudyHit> m_studies; ///< in the source's order; rows store their index in it
    std::vector<std::vector<core::SeriesHit>> m_series; ///< series of each study, as far as known
};

} // namespace ui

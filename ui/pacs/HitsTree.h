// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/PacsQuery.h"

#include <QTreeWidget>

#include <functional>
#include <optional>
#include <vector>

namespace ui {

/// What a source holds: studies that open to their series, which are fetched then. The newest come
/// first; a click on a column's head orders the studies by it, series keep the source's order.
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
    /// In place of series that could not be had.
    void showTrouble(const QString& studyUid, const QString& sentence);
    /// Marks what is here already. @param isHere asked for each row
    void markHere(const std::function<bool(const Choice&)>& isHere);
    [[nodiscard]] std::optional<Choice> chosen() const;

Q_SIGNALS:
    /// A study was opened whose series are not known yet.
    void seriesAsked(const QString& studyUid);
    void choiceChanged();
    void openAsked();

private:
    [[nodiscard]] std::optional<Choice> choiceOf(const QTreeWidgetItem* item) const;
    [[nodiscard]] QTreeWidgetItem* rowOf(const QString& studyUid) const;

    std::vector<core::StudyHit> m_studies; ///< in the source's order; rows know their place in it
    std::vector<std::vector<core::SeriesHit>> m_series; ///< of each, as far as they are known
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/DownloadCache.h"
#include "core/sources/PacsSource.h"
#include "ui/pacs/HitsTree.h"
#include "ui/tasks/BackgroundJob.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

class CopiesRow;
class SearchForm;
class SeriesPreview;
class StateLine;

/// Browses the studies of a PACS source: searches, shows a picture of a series, downloads into the
/// local copies, and opens. Everything that waits for a network or a disk runs on other threads.
class PacsBrowserDialog : public QDialog {
    Q_OBJECT

public:
    explicit PacsBrowserDialog(QWidget* parent = nullptr);
    ~PacsBrowserDialog() override;

Q_SIGNALS:
    /// The folder that holds the complete chosen study or series.
    void openRequested(const QString& folder);

private:
    void build();
    QWidget* sourceRow();
    void fillSources();
    [[nodiscard]] const core::PacsSource* source() const;
    void test();
    void search();
    void askForSeries(const QString& studyUid);
    void askForNextSeries();
    void showChoice();
    void download(bool thenOpen);
    /// @param present images in the copy
    /// @param counted what the source counts; −1: it does not say
    void sayDownloaded(const core::Retrieved& got, int present, int counted);
    void showButtons();
    void showCopies();
    void markCopies();
    [[nodiscard]] QString pathOf(const HitsTree::Choice& choice) const;
    /// The folder of the local copy that holds the choice: its own, or its study's. Empty if there
    /// is none.
    [[nodiscard]] QString copyOf(const HitsTree::Choice& choice) const;
    void reject() override;

    core::DownloadCache m_cache;
    std::vector<core::PacsSource> m_sources;
    core::PacsSource m_searched; ///< where the hits come from
    QStringList m_awaited; ///< studies whose series are asked for, in turn; the first one is now
    QComboBox* m_source;
    SearchForm* m_form;
    HitsTree* m_hits;
    SeriesPreview* m_preview;
    StateLine* m_state;
    QProgressBar* m_progress;
    CopiesRow* m_copies;
    QPushButton* m_test;
    QPushButton* m_edit;
    QPushButton* m_search;
    QPushButton* m_download;
    QPushButton* m_open;
    QPushButton* m_close;
    BackgroundJob m_queryJob;
    BackgroundJob m_seriesJob;
    BackgroundJob m_downloadJob;
};

} // namespace ui

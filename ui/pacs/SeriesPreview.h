// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/DownloadCache.h"
#include "core/sources/PacsSource.h"
#include "ui/pacs/HitsTree.h"
#include "ui/tasks/BackgroundJob.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QImage;
class QLabel;

namespace ui {

/// Shows, beside the search results, the middle picture of the chosen series, and which patient it
/// belongs to. It requests the picture once a choice has been unchanged for a moment.
class SeriesPreview : public QWidget {
    Q_OBJECT

public:
    explicit SeriesPreview(const core::DownloadCache& cache, QWidget* parent = nullptr);

    /// @param source where the hits come from
    void showChoice(const std::optional<HitsTree::Choice>& choice, const core::PacsSource& source);
    /// Drops the picture that is being fetched.
    void stop();

private:
    void ask();
    void showPicture(const QImage& picture);
    void sayInstead(const QString& sentence, const QString& why = {});

    core::DownloadCache m_cache;
    core::PacsSource m_source;
    std::optional<HitsTree::Choice> m_choice;
    QLabel* m_picture;
    QLabel* m_words;
    QTimer m_delay;
    BackgroundJob m_job;
};

} // namespace ui

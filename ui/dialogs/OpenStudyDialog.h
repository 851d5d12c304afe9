// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"

#include <QDialog>

#include <memory>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace ui {

class ThumbnailLoader;

/// The volumes of a folder, to choose one: patient, date, description, slices, a picture, problems.
/// Nothing is chosen beforehand.
class OpenStudyDialog : public QDialog {
    Q_OBJECT

public:
    explicit OpenStudyDialog(const core::StudyListing& listing, QWidget* parent = nullptr);
    ~OpenStudyDialog() override;

    /// Key of the chosen entry; empty while none is.
    [[nodiscard]] QString chosenKey() const;

private:
    void addRow(const core::SeriesEntry& entry);
    void showPicture(int row, const QImage& picture);

    QTreeWidget* m_list;
    QPushButton* m_open;
    std::unique_ptr<ThumbnailLoader> m_pictures;
};

} // namespace ui

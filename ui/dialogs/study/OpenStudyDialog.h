// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"

#include <QDialog>

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace ui {

class ThumbnailLoader;

/// Asks which volume of a folder to open: shows patient, date, description, slices, a picture and
/// problems of each, and for a time series also its points. Nothing is preselected unless there is
/// only one volume.
class OpenStudyDialog : public QDialog {
    Q_OBJECT

public:
    explicit OpenStudyDialog(const core::StudyListing& listing, QWidget* parent = nullptr);
    ~OpenStudyDialog() override;

    /// Key of the chosen entry and point in time; empty if none is chosen.
    [[nodiscard]] QString chosenKey() const;

private:
    void addRow(const core::SeriesEntry& entry);
    void showPicture(int row, const QImage& picture);
    void offerTimes();

    std::vector<core::SeriesEntry> m_entries; ///< row by row
    QTreeWidget* m_list;
    QWidget* m_timeRow;
    QComboBox* m_time;
    QPushButton* m_open;
    std::unique_ptr<ThumbnailLoader> m_pictures;
};

} // namespace ui

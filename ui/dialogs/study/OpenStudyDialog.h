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

/// The volumes of a folder, to choose one: patient, date, description, slices, a picture, problems;
/// of a series in time also the point. Nothing is chosen beforehand, but a volume that is the only
/// one.
class OpenStudyDialog : public QDialog {
    Q_OBJECT

public:
    explicit OpenStudyDialog(const core::StudyListing& listing, QWidget* parent = nullptr);
    ~OpenStudyDialog() override;

    /// Key of the chosen entry at the chosen point in time; empty while none is.
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

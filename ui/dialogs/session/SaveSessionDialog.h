// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileDialog>

class QCheckBox;
class QLabel;

namespace ui {

/// Asks where to save a session, and whether the images of the study are saved in it.
class SaveSessionDialog : public QFileDialog {
    Q_OBJECT

public:
    SaveSessionDialog(const QString& folder, const QString& name, QWidget* parent = nullptr);

    /// Adds the question about images, which is not asked otherwise.
    /// @param included initial state of the tick
    /// @param studyThere whether the session works without them
    void offerImages(bool included, bool studyThere);
    [[nodiscard]] bool wantsImages() const;

private:
    void explain();

    QCheckBox* m_images;
    QLabel* m_hint;
    bool m_studyThere = true;
};

} // namespace ui

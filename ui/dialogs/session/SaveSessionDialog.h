// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileDialog>

class QCheckBox;
class QLabel;

namespace ui {

/// Where a session is to be saved, and whether the study's images go with it.
class SaveSessionDialog : public QFileDialog {
    Q_OBJECT

public:
    SaveSessionDialog(const QString& folder, const QString& name, QWidget* parent = nullptr);

    /// Until this is called images are no question.
    /// @param included the tick to begin with
    /// @param studyThere whether the session can do without them
    void offerImages(bool included, bool studyThere);
    [[nodiscard]] bool wantsImages() const;

private:
    void explain();

    QCheckBox* m_images;
    QLabel* m_hint;
    bool m_studyThere = true;
};

} // namespace ui

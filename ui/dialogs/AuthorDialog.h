// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QLineEdit;

namespace ui {

/// Asks for the user's name in the audit trail; on OK the name becomes the setting (AuthorName.h).
class AuthorDialog : public QDialog {
    Q_OBJECT

public:
    explicit AuthorDialog(QWidget* parent = nullptr);

    void accept() override;

private:
    QLineEdit* m_name = nullptr;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/PacsSource.h"
#include "ui/tasks/BackgroundJob.h"

#include <QDialog>

#include <vector>

class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace ui {

class StateLine;
/// Edits the list of named sources: adds, changes, tests and removes them. OK saves them
/// (PacsSources.h).
class SourcesDialog : public QDialog {
    Q_OBJECT

public:
    explicit SourcesDialog(QWidget* parent = nullptr);

private:
    QLineEdit* field(
        QFormLayout& form, const char* name, const QString& label, const QString& says);
    /// Adds a button to the field that opens a file dialog.
    void offerFiles(QLineEdit& edit);
    void add();
    void remove();
    void showSource();
    void takeOver();
    void showKind();
    void test();
    void keep();
    /// The source that the fields describe. Errors: InvalidField.
    [[nodiscard]] core::Result<core::PacsSource> source() const;

    std::vector<core::PacsSource> m_sources;
    bool m_filling = false;
    QListWidget* m_list;
    QWidget* m_fields;
    QFormLayout* m_form;
    QLineEdit* m_name;
    QLineEdit* m_address;
    QLineEdit* m_ownTitle;
    QSpinBox* m_movePort;
    QLineEdit* m_loginFile;
    QLineEdit* m_user;
    QLineEdit* m_password;
    QLineEdit* m_authority;
    QLineEdit* m_certificate;
    QLineEdit* m_key;
    QSpinBox* m_timeout;
    QPushButton* m_remove;
    QPushButton* m_test;
    QPushButton* m_ok;
    StateLine* m_state;
    BackgroundJob m_job;
};

} // namespace ui

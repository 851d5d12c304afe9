// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/PacsQuery.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace ui {

/// What to look for at a source: patient, dates, kind, number, description.
class SearchForm : public QWidget {
    Q_OBJECT

public:
    explicit SearchForm(QWidget* parent = nullptr);

    /// As the fields say. A name, number or text is looked for at the beginning unless it says
    /// otherwise by `*`.
    [[nodiscard]] core::StudyFilter filter() const;
    /// Why it cannot be asked for; empty: it can.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    void searchAsked();
    void changed();

private:
    QLineEdit* field(const char* name, const QString& placeholder);

    QLineEdit* m_name;
    QLineEdit* m_id;
    QLineEdit* m_from;
    QLineEdit* m_to;
    QComboBox* m_modality;
    QLineEdit* m_accession;
    QLineEdit* m_description;
};

} // namespace ui

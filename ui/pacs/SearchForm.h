// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/PacsQuery.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace ui {

/// The fields of a search at a source: patient, dates, modality, accession number, description.
class SearchForm : public QWidget {
    Q_OBJECT

public:
    explicit SearchForm(QWidget* parent = nullptr);

    /// The search filter of the fields. A name, number or text matches at the beginning, unless the
    /// user writes `*`.
    [[nodiscard]] core::StudyFilter filter() const;
    /// Why the fields cannot be searched for; empty if they can.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    void searchRequested();
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

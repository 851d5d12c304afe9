// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/CodeDialog.h"

#include "ui/base/SegmentCodes.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/CodeDetails.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include <array>

namespace ui {

bool isSnomedIdentifier(const QString& value)
{
    if (value.size() < 6 || value.size() > 18)
        return false;
    // The dihedral group D5: products of its elements, and the permutation for each digit's place.
    static constexpr std::array<std::array<int, 10>, 8> permutation{{
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
        {1, 5, 7, 6, 2, 8, 3, 0, 9, 4},
        {5, 8, 0, 3, 7, 9, 6, 1, 4, 2},
        {8, 9, 1, 6, 0, 4, 3, 5, 2, 7},
        {9, 4, 5, 3, 1, 2, 6, 8, 7, 0},
        {4, 2, 8, 6, 5, 7, 3, 9, 0, 1},
        {2, 7, 9, 3, 8, 0, 6, 4, 1, 5},
        {7, 0, 4, 6, 9, 1, 3, 2, 5, 8},
    }};
    const auto product = [](int a, int b) {
        const int rotation = a % 5;
        if (a < 5)
            return b < 5 ? (rotation + b) % 5 : 5 + (rotation + b) % 5;
        return b < 5 ? 5 + (rotation - b % 5 + 5) % 5 : (rotation - b % 5 + 5) % 5;
    };
    int check = 0;
    for (qsizetype i = 0; i < value.size(); ++i) {
        const QChar digit = value[value.size() - 1 - i];
        if (digit < QLatin1Char('0') || digit > QLatin1Char('9'))
            return false;
        check = product(check, permutation[std::size_t(i % 8)][std::size_t(digit.digitValue())]);
    }
    return check == 0;
}

CodeDialog::CodeDialog(const QString& segment, const core::CodedConcept& present, QWidget* parent)
    : QDialog(parent)
    , m_search(new QLineEdit(this))
    , m_list(new QTreeWidget(this))
    , m_value(new QLineEdit(this))
    , m_meaning(new QLineEdit(this))
    , m_problem(new QLabel(this))
{
    setWindowTitle(tr("What is “%1”?").arg(segment));
    resize(460, 560);
    m_search->setObjectName(QStringLiteral("codeSearch"));
    m_search->setPlaceholderText(tr("Search: liver, ventricle, mass …"));
    m_search->setClearButtonEnabled(true);
    m_list->setObjectName(QStringLiteral("codeList"));
    m_list->setHeaderLabels({tr("Meaning"), tr("SNOMED CT")});
    m_list->setColumnWidth(0, 280);
    m_list->setUniformRowHeights(true);
    m_value->setObjectName(QStringLiteral("codeValue"));
    m_value->setText(present.value);
    m_meaning->setObjectName(QStringLiteral("codeMeaning"));
    m_meaning->setText(present.meaning);
    m_problem->setProperty("role", QStringLiteral("caution"));
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);

    auto* form = new QFormLayout;
    form->addRow(tr("SNOMED CT concept"), m_value);
    form->addRow(tr("Meaning"), m_meaning);
    CodeDetails::alignLabels(*form);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setText(tr("Code the segment"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_search);
    layout->addWidget(m_list, 1);
    layout->addWidget(new QLabel(tr("Or any other concept:"), this));
    layout->addLayout(form);
    layout->addWidget(m_problem);
    layout->addWidget(buttons);
    tabAsLaidOut(*this);

    fillList();
    connect(m_search, &QLineEdit::textChanged, this, &CodeDialog::narrow);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &CodeDialog::takeRow);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, [this](const QTreeWidgetItem* item) {
        if (item->parent() && m_ok->isEnabled())
            accept();
    });
    connect(m_value, &QLineEdit::textChanged, this, &CodeDialog::check);
    connect(m_meaning, &QLineEdit::textChanged, this, &CodeDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
    m_search->setFocus();
    if (!present.isSet())
        choose(segment);
}

/// What bears the segment's own name is most likely meant.
void CodeDialog::choose(const QString& name)
{
    for (QTreeWidgetItemIterator at(m_list); *at; ++at) {
        if ((*at)->parent() && (*at)->text(0).compare(name, Qt::CaseInsensitive) == 0) {
            m_list->setCurrentItem(*at);
            m_list->scrollToItem(*at);
            return;
        }
    }
}

core::CodedConcept CodeDialog::code() const
{
    return {QStringLiteral("SCT"), m_value->text().trimmed(), m_meaning->text().trimmed()};
}

void CodeDialog::askDetails(const core::SegCodes& present)
{
    m_details = new CodeDetails(this);
    m_details->setCodes(present);
    auto* column = qobject_cast<QVBoxLayout*>(layout());
    const int at = column->indexOf(m_problem);
    column->insertWidget(at, m_details);
    column->insertWidget(at, new QLabel(tr("In this export's DICOM SEG also:"), this));
    resize(width(), 680);
    tabAsLaidOut(*this);
}

core::SegCodes CodeDialog::details() const
{
    return m_details ? m_details->codes() : core::SegCodes();
}

void CodeDialog::fillList()
{
    QTreeWidgetItem* group = nullptr;
    for (const SegmentCode& entry : segmentCodes()) {
        if (!group || group->text(0) != entry.group) {
            group = new QTreeWidgetItem(m_list, {entry.group});
            group->setFlags(Qt::ItemIsEnabled);
            group->setFirstColumnSpanned(true);
            group->setFont(0, theme::headingFont());
            group->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(group, {entry.code.meaning, entry.code.value});
        item->setForeground(1, theme::secondary);
    }
}

void CodeDialog::narrow(const QString& letters)
{
    QTreeWidgetItem* first = nullptr;
    for (int g = 0; g < m_list->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = m_list->topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const bool shown = item->text(0).contains(letters.trimmed(), Qt::CaseInsensitive)
                || item->text(1).startsWith(letters.trimmed());
            item->setHidden(!shown);
            any = any || shown;
            if (shown && !first)
                first = item;
        }
        group->setHidden(!any);
    }
    if (first && !letters.trimmed().isEmpty())
        m_list->setCurrentItem(first);
}

void CodeDialog::takeRow()
{
    const QList<QTreeWidgetItem*> chosen = m_list->selectedItems();
    if (chosen.isEmpty() || !chosen.front()->parent())
        return;
    m_value->setText(chosen.front()->text(1));
    m_meaning->setText(chosen.front()->text(0));
}

void CodeDialog::check()
{
    const core::CodedConcept chosen = code();
    QString problem;
    if (!chosen.value.isEmpty() && !isSnomedIdentifier(chosen.value))
        problem = tr("%1 is not a SNOMED CT identifier: its check digit does not agree")
                      .arg(chosen.value);
    else if (!chosen.value.isEmpty() && chosen.meaning.isEmpty())
        problem = tr("The concept needs its meaning in words");
    m_problem->setText(problem);
    m_ok->setEnabled(problem.isEmpty() && !chosen.value.isEmpty());
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/SearchForm.h"

#include "ui/base/Theme.h"

#include <QComboBox>
#include <QDate>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include <optional>

namespace ui {

namespace {

/// "2024-01-31" and "20240131" as DICOM writes it; "" for nothing; none for what is no date.
std::optional<QString> dicomDay(const QString& text)
{
    const QString plain = text.trimmed();
    if (plain.isEmpty())
        return QString();
    for (const char* form : {"yyyy-MM-dd", "yyyyMMdd", "d.M.yyyy"}) {
        const QDate day = QDate::fromString(plain, QLatin1String(form));
        if (day.isValid())
            return day.toString(QStringLiteral("yyyyMMdd"));
    }
    return std::nullopt;
}

QString startingWith(const QLineEdit& field)
{
    const QString text = field.text().trimmed();
    return text.isEmpty() || text.contains(u'*') || text.contains(u'?') ? text : text + u'*';
}

} // namespace

SearchForm::SearchForm(QWidget* parent)
    : QWidget(parent)
    , m_name(field("pacsName", QStringLiteral("Doe^J, Müller …")))
    , m_id(field("pacsId", tr("whole ID")))
    , m_from(field("pacsFrom", QStringLiteral("YYYY-MM-DD")))
    , m_to(field("pacsTo", QStringLiteral("YYYY-MM-DD")))
    , m_modality(new QComboBox(this))
    , m_accession(field("pacsAccession", tr("whole number")))
    , m_description(field("pacsDescription", QStringLiteral("*thorax*")))
{
    m_modality->setObjectName(QStringLiteral("pacsModality"));
    m_modality->setEditable(true);
    m_modality->addItems({QString(), QStringLiteral("CT"), QStringLiteral("MR"),
        QStringLiteral("PT"), QStringLiteral("SEG"), QStringLiteral("RTSTRUCT")});
    m_modality->lineEdit()->setPlaceholderText(QStringLiteral("any"));
    connect(m_modality->lineEdit(), &QLineEdit::returnPressed, this, &SearchForm::searchRequested);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(theme::smallPadding);
    grid->setVerticalSpacing(2);
    const auto put = [&](int column, const char* title, QWidget* input, int stretch) {
        auto* label = new QLabel(QLatin1String(title), this);
        label->setProperty("role", QStringLiteral("secondary"));
        label->setFont(theme::smallFont());
        label->setBuddy(input);
        grid->addWidget(label, 0, column);
        grid->addWidget(input, 1, column);
        grid->setColumnStretch(column, stretch);
    };
    put(0, "&Patient name", m_name, 5);
    put(1, "Patient &ID", m_id, 3);
    put(2, "Study date &from", m_from, 3);
    put(3, "&to", m_to, 3);
    put(4, "&Modality", m_modality, 2);
    put(5, "&Accession number", m_accession, 3);
    put(6, "Study &description", m_description, 4);
}

QLineEdit* SearchForm::field(const char* name, const QString& placeholder)
{
    auto* edit = new QLineEdit(this);
    edit->setObjectName(QLatin1String(name));
    edit->setPlaceholderText(placeholder);
    connect(edit, &QLineEdit::returnPressed, this, &SearchForm::searchRequested);
    connect(edit, &QLineEdit::textChanged, this, &SearchForm::changed);
    return edit;
}

core::StudyFilter SearchForm::filter() const
{
    const QString from = dicomDay(m_from->text()).value_or(QString());
    const QString to = dicomDay(m_to->text()).value_or(QString());
    QString dates = from + u'-' + to;
    if (from.isEmpty() && to.isEmpty())
        dates.clear();
    return {.patientName = startingWith(*m_name),
        .patientId = m_id->text().trimmed(),
        .studyDate = dates,
        .modality = m_modality->currentText().trimmed().toUpper(),
        .accessionNumber = m_accession->text().trimmed(),
        .description = startingWith(*m_description),
        .studyUid = {}};
}

QString SearchForm::problem() const
{
    for (const QLineEdit* date : {m_from, m_to}) {
        if (!dicomDay(date->text()))
            return tr("“%1” is no date; write 2024-01-31.").arg(date->text().trimmed());
    }
    return {};
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/SourcesDialog.h"
#include "ui/base/TabOrder.h"
#include "ui/widgets/StateLine.h"
#include "ui/widgets/fields/NumberField.h"

#include "ui/base/ErrorText.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/settings/PacsSources.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <utility>

namespace ui {

SourcesDialog::SourcesDialog(QWidget* parent)
    : QDialog(parent)
    , m_sources(pacsSources())
    , m_list(new QListWidget(this))
    , m_fields(new QWidget(this))
    , m_form(new QFormLayout(m_fields))
    , m_movePort(new WholeNumberField(m_fields))
    , m_timeout(new WholeNumberField(m_fields))
    , m_remove(new QPushButton(tr("Remove"), this))
    , m_test(new QPushButton(tr("Test"), this))
    , m_ok(nullptr)
    , m_state(new StateLine(QStringLiteral("sourcesState"), this))
{
    setWindowTitle(tr("Sources"));
    resize(820, 520);
    m_list->setObjectName(QStringLiteral("sourcesList"));
    m_list->setFixedWidth(210);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(theme::padding);
    m_form->setVerticalSpacing(theme::smallPadding);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_name = field(*m_form, "sourceName", tr("Name"), tr("Archive"));
    m_address = field(*m_form, "sourceAddress", tr("Address"),
        QStringLiteral("AETITLE@host:port or https://host/dicom-web"));
    m_ownTitle =
        field(*m_form, "sourceOwnTitle", tr("Our AE title"), tr("BURIN; the node must know it"));
    m_movePort->setObjectName(QStringLiteral("sourceMovePort"));
    m_movePort->setRange(0, 65535);
    m_movePort->setSpecialValueText(tr("over the same connection (C-GET)"));
    m_movePort->setPrefix(tr("to our port "));
    m_movePort->setSuffix(QStringLiteral(" (C-MOVE)"));
    m_form->addRow(tr("Images come"), m_movePort);
    m_loginFile = field(*m_form, "sourceLoginFile", tr("Login file"),
        tr("holds user:password or Bearer TOKEN; only you may read it"));
    m_user = field(*m_form, "sourceUser", tr("or user"), QString());
    m_password = field(
        *m_form, "sourcePassword", tr("and password"), tr("known until Burin ends, kept nowhere"));
    m_password->setEchoMode(QLineEdit::Password);
    m_authority = field(*m_form, "sourceAuthority", tr("TLS: authority"), QString());
    m_certificate = field(*m_form, "sourceCertificate", tr("TLS: our certificate"),
        tr("PEM file, where the source asks for it"));
    m_key = field(*m_form, "sourceKey", tr("TLS: our key"), tr("PEM file"));
    m_timeout->setObjectName(QStringLiteral("sourceTimeout"));
    m_timeout->setRange(1, 3600);
    m_timeout->setSuffix(tr(" s without a sign of life"));
    m_form->addRow(tr("Give up after"), m_timeout);

    auto* addOne = new QPushButton(tr("Add"), this);
    for (QPushButton* button : {addOne, m_remove, m_test})
        button->setAutoDefault(false);
    auto* edits = new QHBoxLayout;
    edits->addWidget(addOne);
    edits->addWidget(m_remove);
    auto* left = new QVBoxLayout;
    left->addWidget(m_list, 1);
    left->addLayout(edits);
    auto* right = new QVBoxLayout;
    right->addWidget(m_fields);
    right->addSpacing(theme::smallPadding);
    right->addWidget(m_test, 0, Qt::AlignLeft);
    right->addWidget(m_state);
    right->addStretch(1);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(theme::padding);
    columns->addLayout(left);
    columns->addLayout(right, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addLayout(columns, 1);
    layout->addWidget(buttons);
    tabAsLaidOut(*this);

    connect(addOne, &QPushButton::clicked, this, &SourcesDialog::add);
    connect(m_remove, &QPushButton::clicked, this, &SourcesDialog::remove);
    connect(m_test, &QPushButton::clicked, this, &SourcesDialog::test);
    connect(buttons, &QDialogButtonBox::accepted, this, &SourcesDialog::keep);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::currentRowChanged, this, &SourcesDialog::showSource);
    connect(m_movePort, &QSpinBox::valueChanged, this, &SourcesDialog::takeOver);
    connect(m_timeout, &QSpinBox::valueChanged, this, &SourcesDialog::takeOver);
    for (QLineEdit* file : {m_loginFile, m_authority, m_certificate, m_key})
        offerFiles(*file);
    for (const core::PacsSource& one : m_sources)
        m_list->addItem(one.name);
    if (m_sources.empty())
        add();
    else
        m_list->setCurrentRow(0);
}

QLineEdit* SourcesDialog::field(
    QFormLayout& form, const char* name, const QString& label, const QString& says)
{
    auto* edit = new QLineEdit(m_fields);
    edit->setObjectName(QLatin1String(name));
    edit->setPlaceholderText(says);
    form.addRow(label, edit);
    connect(edit, &QLineEdit::textChanged, this, &SourcesDialog::takeOver);
    return edit;
}

void SourcesDialog::offerFiles(QLineEdit& edit)
{
    const QAction* browse =
        edit.addAction(stateIcon(QStringLiteral("open")), QLineEdit::TrailingPosition);
    connect(browse, &QAction::triggered, this, [this, &edit] {
        const QString file = QFileDialog::getOpenFileName(
            this, m_form->labelForField(&edit)->property("text").toString(), edit.text());
        if (!file.isEmpty())
            edit.setText(file);
    });
}

void SourcesDialog::add()
{
    core::PacsSource fresh{.name = tr("New source"), .node = {}, .movePort = {}};
    m_sources.push_back(std::move(fresh));
    m_list->addItem(m_sources.back().name);
    m_list->setCurrentRow(m_list->count() - 1);
    m_name->selectAll();
    m_name->setFocus();
}

void SourcesDialog::remove()
{
    const int row = m_list->currentRow();
    if (row < 0)
        return;
    {
        const QSignalBlocker quiet(m_list);
        m_sources.erase(m_sources.begin() + row);
        delete m_list->takeItem(row);
    }
    m_list->setEnabled(true);
    m_ok->setEnabled(true);
    m_test->setEnabled(false);
    m_state->say(QString());
    showSource();
}

void SourcesDialog::showSource()
{
    m_job.cancel();
    const int row = m_list->currentRow();
    const bool isOne = row >= 0 && row < int(m_sources.size());
    m_fields->setEnabled(isOne);
    m_remove->setEnabled(isOne);
    m_filling = true;
    const core::PacsSource source = isOne ? m_sources[std::size_t(row)] : core::PacsSource();
    const auto* web = std::get_if<core::WebNode>(&source.node);
    const auto* dicom = std::get_if<core::PacsNode>(&source.node);
    const bool isNew = dicom && dicom->host.isEmpty();
    m_name->setText(source.name);
    m_address->setText(isNew ? QString() : source.address());
    m_ownTitle->setText(dicom ? dicom->ownAeTitle : QString());
    m_movePort->setValue(source.movePort.value_or(0));
    m_loginFile->setText(web ? web->loginFile : QString());
    m_user->setText(web ? web->login.user : QString());
    m_password->setText(web ? web->login.password : QString());
    m_authority->setText(web ? web->authorityFile : dicom->tls.authorityFile);
    m_certificate->setText(web ? web->certificateFile : dicom->tls.certificateFile);
    m_key->setText(web ? web->keyFile : dicom->tls.keyFile);
    m_timeout->setValue(web ? web->timeoutSeconds : dicom->timeoutSeconds);
    m_filling = false;
    showKind();
    takeOver();
}

void SourcesDialog::showKind()
{
    const bool isWeb = core::WebNode::isAddress(m_address->text().trimmed());
    const auto show = [this](QWidget* input, bool shown) {
        input->setVisible(shown);
        m_form->labelForField(input)->setVisible(shown);
    };
    for (QWidget* input : {static_cast<QWidget*>(m_ownTitle), static_cast<QWidget*>(m_movePort)})
        show(input, !isWeb);
    for (QWidget* input : {m_loginFile, m_user, m_password})
        show(input, isWeb);
    m_authority->setPlaceholderText(isWeb ? tr("PEM file; empty: those that the system trusts")
                                          : tr("PEM file that signs this one node; empty: no TLS"));
}

core::Result<core::PacsSource> SourcesDialog::source() const
{
    core::Result<core::PacsSource> source = core::PacsSource::parse(m_address->text().trimmed());
    if (!source)
        return source;
    source->name = m_name->text().simplified();
    if (source->name.isEmpty()) {
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("name"),
            core::Clause::saying("the source needs one"));
    }
    if (auto* web = std::get_if<core::WebNode>(&source->node)) {
        web->loginFile = m_loginFile->text().trimmed();
        if (!m_user->text().isEmpty())
            web->login = {.user = m_user->text(), .password = m_password->text(), .token = {}};
        web->authorityFile = m_authority->text().trimmed();
        web->certificateFile = m_certificate->text().trimmed();
        web->keyFile = m_key->text().trimmed();
        web->timeoutSeconds = m_timeout->value();
    } else {
        auto& node = std::get<core::PacsNode>(source->node);
        if (!m_ownTitle->text().trimmed().isEmpty())
            node.ownAeTitle = m_ownTitle->text().trimmed();
        node.tls = {.authorityFile = m_authority->text().trimmed(),
            .certificateFile = m_certificate->text().trimmed(),
            .keyFile = m_key->text().trimmed()};
        node.timeoutSeconds = m_timeout->value();
        if (m_movePort->value() > 0)
            source->movePort = m_movePort->value();
    }
    if (const core::Result<void> sound = source->check(); !sound)
        return tl::unexpected<core::Error>(sound.error());
    return source;
}

void SourcesDialog::takeOver()
{
    const int row = m_list->currentRow();
    if (m_filling || row < 0 || row >= int(m_sources.size()))
        return;
    showKind();
    m_list->item(row)->setText(m_name->text().simplified());
    const core::Result<core::PacsSource> now = source();
    if (now)
        m_sources[std::size_t(row)] = *now;
    else
        m_sources[std::size_t(row)].name = m_name->text().simplified();
    m_ok->setEnabled(now.has_value());
    m_list->setEnabled(now.has_value());
    m_test->setEnabled(now.has_value());
    const bool isBlank = m_address->text().trimmed().isEmpty();
    m_state->say(now || isBlank ? QString() : errorText(now.error()));
}

void SourcesDialog::test()
{
    const core::Result<core::PacsSource> now = source();
    if (!now)
        return;
    m_state->say(tr("Asking %1 …").arg(now->address()));
    m_job.start(
        [this, source = *now](const core::Progress& progress) -> std::function<void()> {
            const core::Result<void> answered = core::echoNode(source, progress);
            return [this, source, answered] {
                if (answered)
                    m_state->say(tr("%1 answers.").arg(source.address()), "good");
                else
                    m_state->say(errorText(answered.error()), "bad");
            };
        },
        [this](const core::Error& error) { m_state->say(errorText(error), "bad"); });
}

void SourcesDialog::keep()
{
    setPacsSources(m_sources);
    accept();
}

} // namespace ui

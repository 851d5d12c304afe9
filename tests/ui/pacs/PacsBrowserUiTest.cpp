// SPDX-License-Identifier: Apache-2.0
#include "core/sources/PacsSource.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/base/ErrorText.h"
#include "ui/pacs/PacsBrowserDialog.h"
#include "ui/pacs/PacsCache.h"
#include "ui/pacs/SendDialog.h"
#include "ui/pacs/SourcesDialog.h"
#include "ui/settings/PacsSources.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <string>

namespace pacsBrowserUiTest {

namespace {

constexpr int patience = 60000; // ms; only a hang takes that long

template <class Widget> Widget& child(const QWidget& dialog, const char* name)
{
    auto* found = dialog.findChild<Widget*>(QLatin1String(name));
    if (!found)
        qFatal("no such widget");
    return *found;
}

QString stateOf(const QWidget& dialog)
{
    return child<QLabel>(dialog, "pacsState").text();
}

/// A disc in noise, so that a picture is something.
int disc(const glm::ivec3& index)
{
    const int x = index.x - 32;
    const int y = index.y - 24;
    return x * x + y * y < 18 * 18 ? 1100 + 40 * index.z : 20;
}

} // namespace

/// The PACS browser against real servers: looks for studies, shows a picture, downloads, opens;
/// what goes wrong is one sentence, and the window is never held up.
class PacsBrowserUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void fromSearchToWindow_data();
    void fromSearchToWindow();
    void wholeStudy();
    void nothingFound();
    void serverGone();
    void abortKeepsWhatCame();
    void datesAreChecked();
    void openCopiesStay();
    void sourcesAreKept();
    void halfOfTlsIsCompleted();
    void masksAreSent();

private:
    [[nodiscard]] core::PacsSource web() const
    {
        return {.name = QStringLiteral("Cloud"), .node = m_server->webNode(), .movePort = {}};
    }
    [[nodiscard]] core::PacsSource dicom() const
    {
        return {.name = QStringLiteral("Archive"), .node = m_server->node(), .movePort = {}};
    }
    /// Looks for all studies; waits.
    static void search(ui::PacsBrowserDialog& dialog);
    /// The row of Jane's study, opened, with its series.
    static QTreeWidgetItem* jane(ui::PacsBrowserDialog& dialog);

    QTemporaryDir m_home;
    std::unique_ptr<test::PacsServer> m_server;
    int m_slices = 0;
};

#define NEED_SERVER                                                                                \
    if (!m_server->absent().isEmpty())                                                             \
    QSKIP(qPrintable(m_server->absent()))

void PacsBrowserUiTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", m_home.filePath(QStringLiteral("cache")).toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("burin"));
    QCoreApplication::setApplicationName(QStringLiteral("burin"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_home.path());
    m_server = std::make_unique<test::PacsServer>(test::PacsServer::Program::OrthancWeb);
    QVERIFY2(m_server->problem().isEmpty(), qPrintable(m_server->problem()));
    if (!m_server->absent().isEmpty())
        return;
    QStringList files;
    const char* names[] = {"Doe^Jane", "M\xc3\xbcller^J\xc3\xb6rg", "Okonkwo^Adaeze^N"};
    const char* texts[] = {"CT thorax",
        ("Sch\xc3\xa4"
         "del nativ"),
        "Knie rechts"};
    for (int patient = 0; patient < 3; ++patient) {
        for (int number = 1; number <= 2; ++number) {
            test::SyntheticSeries series;
            series.size = {64, 48, patient == 0 ? 20 : 6};
            series.stored = disc;
            series.modality = patient == 2 ? QStringLiteral("MR") : QStringLiteral("CT");
            series.studyUid = QStringLiteral("2.25.50%1").arg(patient);
            series.seriesUid = QStringLiteral("2.25.50%1%2").arg(patient).arg(number);
            series.adjust = [&, patient, number](DcmDataset& set, int k) {
                const auto put = [&set](const DcmTagKey& tag, const std::string& value) {
                    set.putAndInsertString(tag, value.c_str());
                };
                put(DCM_SpecificCharacterSet, "ISO_IR 192");
                put(DCM_PatientName, names[patient]);
                put(DCM_PatientID, "P" + std::to_string(4711 + patient));
                put(DCM_PatientBirthDate, "196" + std::to_string(patient) + "0302");
                put(DCM_StudyDate, "2024010" + std::to_string(1 + patient));
                put(DCM_StudyDescription, texts[patient]);
                put(DCM_AccessionNumber, "A" + std::to_string(patient));
                put(DCM_SeriesNumber, std::to_string(number));
                put(DCM_InstanceNumber, std::to_string(k + 1));
                put(DCM_SeriesDescription, number == 1 ? "axial soft" : "axial bone");
                put(DCM_SOPInstanceUID,
                    "2.25.7" + std::to_string(patient) + std::to_string(number)
                        + std::to_string(100 + k));
            };
            files += test::writeSeries(
                series, m_home.filePath(QStringLiteral("s%1%2").arg(patient).arg(number)));
            if (patient == 0)
                m_slices = series.size.z;
        }
    }
    const auto sent = core::sendFiles(web(), files, core::Progress());
    QVERIFY2(sent.has_value(), sent ? "" : qPrintable(ui::errorText(sent.error())));
}

void PacsBrowserUiTest::init()
{
    test::failOnUnexpectedMessages();
    ui::pacsCache().clear();
}

void PacsBrowserUiTest::search(ui::PacsBrowserDialog& dialog)
{
    child<QPushButton>(dialog, "pacsSearch").click();
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QTreeWidget>(dialog, "pacsHits").topLevelItemCount() > 0, patience);
}

QTreeWidgetItem* PacsBrowserUiTest::jane(ui::PacsBrowserDialog& dialog)
{
    auto& hits = child<QTreeWidget>(dialog, "pacsHits");
    const auto found = hits.findItems(QStringLiteral("Doe, Jane"), Qt::MatchExactly);
    if (found.size() != 1)
        return nullptr;
    found.front()->setExpanded(true);
    const bool came = QTest::qWaitFor([&] { return found.front()->childCount() == 2; }, patience);
    return came ? found.front() : nullptr;
}

void PacsBrowserUiTest::fromSearchToWindow_data()
{
    QTest::addColumn<bool>("isWeb");
    QTest::newRow("DICOMweb") << true;
    QTest::newRow("C-FIND, C-GET") << false;
}

void PacsBrowserUiTest::fromSearchToWindow()
{
    NEED_SERVER;
    QFETCH(bool, isWeb);
    ui::setPacsSources({isWeb ? web() : dicom()});
    test::WindowFixture fixture(test::headFirstSupine());
    QSignalSpy loaded(&fixture.window.opener(), &ui::StudyOpener::loaded);
    fixture.window.move(0, 0);
    fixture.window.actionTable()[QStringLiteral("file.fromPacs")].trigger();
    const QPointer<ui::PacsBrowserDialog> dialog =
        fixture.window.findChild<ui::PacsBrowserDialog*>();
    QVERIFY(dialog);
    QVERIFY(QTest::qWaitForWindowExposed(dialog));
    search(*dialog);
    auto& hits = child<QTreeWidget>(*dialog, "pacsHits");
    QCOMPARE(hits.topLevelItemCount(), 3);
    QTRY_COMPARE(stateOf(*dialog), QStringLiteral("3 studies"));
    QTreeWidgetItem* study = jane(*dialog);
    QVERIFY(study);
    QCOMPARE(study->text(2), QStringLiteral("2024-01-01"));
    // The newest come first; a click on a column's head orders by it, and choices stay what they
    // say.
    QCOMPARE(hits.topLevelItem(0)->text(2), QStringLiteral("2024-01-03"));
    QCOMPARE(hits.indexOfTopLevelItem(study), 2);
    hits.sortByColumn(0, Qt::AscendingOrder);
    QCOMPARE(hits.indexOfTopLevelItem(study), 0);
    QCOMPARE(study->child(0)->text(0), QStringLiteral("Series 1"));
    hits.sortByColumn(2, Qt::DescendingOrder);
    QCOMPARE(study->child(0)->text(0), QStringLiteral("Series 1"));
    if (isWeb)
        QCOMPARE(study->text(6), QString::number(2 * m_slices));
    QTreeWidgetItem* series = study->child(1);
    QCOMPARE(series->text(0), QStringLiteral("Series 2"));
    QCOMPARE(series->text(4), QStringLiteral("axial bone"));
    QCOMPARE(series->text(6), QString::number(m_slices));
    hits.setCurrentItem(series);
    // The picture of its middle: light in the middle, dark at the edge.
    auto& picture = child<QLabel>(*dialog, "pacsPicture");
    QTRY_VERIFY_WITH_TIMEOUT(!picture.pixmap().isNull(), patience);
    const QImage image = picture.pixmap().toImage();
    QVERIFY(qGray(image.pixel(image.rect().center())) > 200);
    QVERIFY(qGray(image.pixel(image.width() / 2 + 75, image.height() / 2)) < 60);
    for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080)}) {
        fixture.window.resize(size);
        dialog->move(fixture.window.geometry().center() - dialog->rect().center());
        // On the screen before that is looked at.
        QGuiApplication::sync();
        fixture.window.repaint();
        dialog->repaint();
        QGuiApplication::sync();
        QVERIFY(dialog->width() <= size.width() && dialog->height() <= size.height());
        const QByteArray name = QByteArray("pacs-") + (isWeb ? "web-" : "dicom-")
            + QByteArray::number(size.width()) + ".png";
        const QRect place = fixture.window.geometry();
        test::look(fixture.window.screen()->grabWindow(
                       0, place.x(), place.y(), place.width(), place.height()),
            name.constData());
    }

    if (isWeb)
        test::look(dialog->grab(), "pacs-browser.png");
    child<QPushButton>(*dialog, "pacsDownload").click();
    QTRY_VERIFY_WITH_TIMEOUT(stateOf(*dialog).startsWith(u'✓'), patience);
    QCOMPARE(stateOf(*dialog), QStringLiteral("✓ %1 images are here, each checked.").arg(m_slices));
    QTRY_COMPARE(series->text(7), QStringLiteral("✓"));
    QCOMPARE(study->child(0)->text(7), QString());
    QTRY_VERIFY(!child<QPushButton>(*dialog, "pacsClear").isHidden());
    child<QPushButton>(*dialog, "pacsOpen").click();
    QTRY_COMPARE_WITH_TIMEOUT(loaded.size(), 1, patience);
    const auto volume = loaded.front().front().value<std::shared_ptr<core::LoadedVolume>>();
    QCOMPARE(volume->volume.geometry.size, (glm::ivec3{64, 48, m_slices}));
    QCOMPARE(volume->volume.identity.patientName, QStringLiteral("Doe^Jane"));
    QVERIFY(!dialog || !dialog->isVisible());
}

void PacsBrowserUiTest::wholeStudy()
{
    NEED_SERVER;
    ui::setPacsSources({web()});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    QSignalSpy asked(&dialog, &ui::PacsBrowserDialog::openRequested);
    search(dialog);
    QTreeWidgetItem* study = jane(dialog);
    QVERIFY(study);
    auto& hits = child<QTreeWidget>(dialog, "pacsHits");
    hits.setCurrentItem(study);
    QVERIFY(child<QPushButton>(dialog, "pacsOpen").isEnabled());
    child<QPushButton>(dialog, "pacsOpen").click();
    QTRY_COMPARE_WITH_TIMEOUT(asked.size(), 1, patience);
    const QDir folder(asked.front().front().toString());
    QCOMPARE(folder.entryList(QDir::Files).size(), 2 * m_slices);
    QVERIFY(!folder.path().contains(QLatin1String("2.25.50")));
}

void PacsBrowserUiTest::nothingFound()
{
    NEED_SERVER;
    ui::setPacsSources({web()});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    child<QLineEdit>(dialog, "pacsName").setText(QStringLiteral("Nobody"));
    QTest::keyClick(&child<QLineEdit>(dialog, "pacsName"), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(stateOf(dialog), QStringLiteral("No study there matches."), patience);
    // What is typed is looked for at the beginning.
    child<QLineEdit>(dialog, "pacsName").setText(QStringLiteral("Oko"));
    child<QPushButton>(dialog, "pacsSearch").click();
    QTRY_COMPARE_WITH_TIMEOUT(stateOf(dialog), QStringLiteral("1 study"), patience);
}

void PacsBrowserUiTest::serverGone()
{
    core::PacsSource gone{.name = QStringLiteral("Gone"), .node = {}, .movePort = {}};
    core::WebNode node;
    node.url = QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(test::freePort()));
    gone.node = node;
    ui::setPacsSources({gone});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    child<QPushButton>(dialog, "pacsSearch").click();
    QTRY_COMPARE_WITH_TIMEOUT(stateOf(dialog),
        node.name() + QStringLiteral(" cannot be reached: Connection refused"), patience);
    QCOMPARE(child<QLabel>(dialog, "pacsState").property("role").toString(), QStringLiteral("bad"));
    test::look(dialog.grab(), "pacs-gone.png");
    QVERIFY(child<QPushButton>(dialog, "pacsSearch").isEnabled());
    QVERIFY(!child<QPushButton>(dialog, "pacsOpen").isEnabled());
}

void PacsBrowserUiTest::abortKeepsWhatCame()
{
    NEED_SERVER;
    // The search passes; amid the download the server falls silent.
    const test::FaultyWire wire(
        m_server->webNode().url.port(), test::FaultyWire::Fault::Stall, 60000);
    core::PacsSource slow = web();
    auto& node = std::get<core::WebNode>(slow.node);
    node.url.setPort(wire.port());
    node.timeoutSeconds = 600;
    ui::setPacsSources({slow});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    search(dialog);
    QTreeWidgetItem* study = jane(dialog);
    QVERIFY(study);
    child<QTreeWidget>(dialog, "pacsHits").setCurrentItem(study);
    child<QPushButton>(dialog, "pacsDownload").click();
    QVERIFY(!child<QPushButton>(dialog, "pacsOpen").isEnabled());
    QCOMPARE(child<QPushButton>(dialog, "pacsClose").text(), QStringLiteral("Abort"));
    // The window lives on meanwhile.
    int ticks = 0;
    QTimer clock;
    connect(&clock, &QTimer::timeout, this, [&ticks] { ++ticks; });
    clock.start(10);
    QTRY_VERIFY(ticks > 10);
    child<QPushButton>(dialog, "pacsClose").click();
    QVERIFY(stateOf(dialog).startsWith(QLatin1String("Aborted.")));
    QVERIFY(dialog.isVisible());
    QVERIFY(child<QPushButton>(dialog, "pacsOpen").isEnabled());
    child<QPushButton>(dialog, "pacsClose").click();
    QVERIFY(!dialog.isVisible());
}

void PacsBrowserUiTest::datesAreChecked()
{
    ui::setPacsSources({});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    QVERIFY(stateOf(dialog).startsWith(QLatin1String("There is no source yet")));
    QVERIFY(!child<QPushButton>(dialog, "pacsSearch").isEnabled());
    child<QLineEdit>(dialog, "pacsFrom").setText(QStringLiteral("yesterday"));
    QCOMPARE(stateOf(dialog), QStringLiteral("“yesterday” is no date; write 2024-01-31."));
    child<QLineEdit>(dialog, "pacsFrom").setText(QStringLiteral("2024-02-29"));
    QCOMPARE(stateOf(dialog), QString());
}

void PacsBrowserUiTest::openCopiesStay()
{
    const core::DownloadCache cache = ui::pacsCache();
    QVERIFY(cache.prepare().has_value());
    const auto entry = [&](const char* uid) {
        const QString path = cache.pathOf(
            QStringLiteral("A@b:104"), {.studyUid = QLatin1String(uid), .seriesUid = {}});
        QDir().mkpath(path);
        QFile file(path + QStringLiteral("/1"));
        if (file.open(QIODevice::WriteOnly))
            file.write("x");
        return path;
    };
    const QString open = entry("1.1");
    const QString other = entry("1.2");
    {
        core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
        volume.volume.sourcePath = open;
        const test::WindowFixture fixture(std::move(volume));
        QCOMPARE(cache.clear(), 1);
        QVERIFY(QFileInfo::exists(open));
        QVERIFY(!QFileInfo::exists(other));
    }
    QCOMPARE(cache.clear(), 1);
    QVERIFY(!QFileInfo::exists(open));
}

void PacsBrowserUiTest::sourcesAreKept()
{
    ui::setPacsSources({});
    ui::SourcesDialog dialog;
    dialog.show();
    auto& ok = *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(!ok.isEnabled());
    child<QLineEdit>(dialog, "sourceName").setText(QStringLiteral("Archive"));
    auto& address = child<QLineEdit>(dialog, "sourceAddress");
    address.setText(QStringLiteral("PACS@10.0.0.7"));
    QVERIFY(!ok.isEnabled());
    QVERIFY(!child<QLabel>(dialog, "sourcesState").text().isEmpty());
    address.setText(QStringLiteral("PACS@10.0.0.7:104"));
    QVERIFY(ok.isEnabled());
    QVERIFY(child<QLineEdit>(dialog, "sourceOwnTitle").isVisible());
    QVERIFY(!child<QLineEdit>(dialog, "sourcePassword").isVisible());
    test::look(dialog.grab(), "pacs-source-dicom.png");
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
        if (button->text() == QLatin1String("Add"))
            button->click();
    }
    QCOMPARE(child<QListWidget>(dialog, "sourcesList").count(), 2);
    child<QLineEdit>(dialog, "sourceName").setText(QStringLiteral("Cloud"));
    address.setText(QStringLiteral("https://pacs.example/dicom-web"));
    QVERIFY(!child<QLineEdit>(dialog, "sourceOwnTitle").isVisible());
    child<QLineEdit>(dialog, "sourceUser").setText(QStringLiteral("jane"));
    child<QLineEdit>(dialog, "sourcePassword").setText(QStringLiteral("secret"));
    QCOMPARE(child<QLineEdit>(dialog, "sourcePassword").echoMode(), QLineEdit::Password);
    test::look(dialog.grab(), "pacs-source-web.png");
    ok.click();
    const auto kept = ui::pacsSources();
    QCOMPARE(kept.size(), std::size_t(2));
    QCOMPARE(kept[0].address(), QStringLiteral("PACS@10.0.0.7:104"));
    QCOMPARE(kept[1].name, QStringLiteral("Cloud"));
    QCOMPARE(std::get<core::WebNode>(kept[1].node).login.password, QStringLiteral("secret"));
}

/// A source of before that has a certificate and no authority is there, and asks for it.
void PacsBrowserUiTest::halfOfTlsIsCompleted()
{
    const core::PacsNode node{.aeTitle = QStringLiteral("PACS"),
        .host = QStringLiteral("10.0.0.7"),
        .tls = {.authorityFile = {},
            .certificateFile = QStringLiteral("/keys/own.pem"),
            .keyFile = QStringLiteral("/keys/own.key")}};
    ui::setPacsSources({{.name = QStringLiteral("Archive"), .node = node, .movePort = {}}});
    ui::SourcesDialog dialog;
    dialog.show();
    QCOMPARE(child<QListWidget>(dialog, "sourcesList").count(), 1);
    QCOMPARE(child<QLineEdit>(dialog, "sourceCertificate").text(), QStringLiteral("/keys/own.pem"));
    auto& ok = *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(!ok.isEnabled());
    QVERIFY(child<QLabel>(dialog, "sourcesState").text().contains(QLatin1String("authority")));
    child<QLineEdit>(dialog, "sourceAuthority").setText(QStringLiteral("/keys/ca.pem"));
    QVERIFY(ok.isEnabled());
    QCOMPARE(child<QLabel>(dialog, "sourcesState").text(), QString());
}

void PacsBrowserUiTest::masksAreSent()
{
    NEED_SERVER;
    ui::setPacsSources({web()});
    test::SyntheticSeries series;
    series.size = {8, 8, 2};
    series.studyUid = QStringLiteral("2.25.600");
    series.seriesUid = QStringLiteral("2.25.601");
    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.602" + std::to_string(k)).c_str());
    };
    const QStringList files = test::writeSeries(series, m_home.filePath(QStringLiteral("masks")));
    ui::SendDialog dialog(files);
    dialog.show();
    child<QPushButton>(dialog, "sendStart").click();
    auto& state = child<QLabel>(dialog, "sendState");
    QTRY_COMPARE_WITH_TIMEOUT(
        state.text(), QStringLiteral("✓ %1 took 2 files.").arg(web().address()), patience);
    test::look(dialog.grab(), "pacs-send.png");
    const auto found = core::findSeries(web(), series.studyUid, core::Progress());
    QVERIFY(found.has_value());
    QCOMPARE(found->size(), std::size_t(1));
    // What is no DICOM stays here.
    QFile notes(m_home.filePath(QStringLiteral("notes.txt")));
    QVERIFY(notes.open(QIODevice::WriteOnly));
    notes.write("not a DICOM file, however long it may be");
    notes.close();
    ui::SendDialog other({notes.fileName()});
    other.show();
    child<QPushButton>(other, "sendStart").click();
    auto& complaint = child<QLabel>(other, "sendState");
    QTRY_COMPARE_WITH_TIMEOUT(
        complaint.property("role").toString(), QStringLiteral("bad"), patience);
    QVERIFY(complaint.text().contains(QLatin1String("notes.txt")));
    // Nor does anything go where nobody answers.
    core::PacsSource off{.name = QStringLiteral("Off"), .node = {}, .movePort = {}};
    core::WebNode node;
    node.url = QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(test::freePort()));
    off.node = node;
    ui::setPacsSources({off});
    ui::SendDialog nowhere(files);
    nowhere.show();
    child<QPushButton>(nowhere, "sendStart").click();
    auto& trouble = child<QLabel>(nowhere, "sendState");
    QTRY_COMPARE_WITH_TIMEOUT(trouble.property("role").toString(), QStringLiteral("bad"), patience);
    QVERIFY2(
        trouble.text().contains(QLatin1String("cannot be reached")), qPrintable(trouble.text()));
    QVERIFY(child<QPushButton>(nowhere, "sendStart").isEnabled());
    test::look(nowhere.grab(), "pacs-send-off.png");
}

BURIN_WINDOW_TEST(PacsBrowserUiTest)

} // namespace pacsBrowserUiTest

#include "PacsBrowserUiTest.moc"

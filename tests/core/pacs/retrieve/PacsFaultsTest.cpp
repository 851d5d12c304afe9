// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "core/pacs/retrieve/PacsRetrieve.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/faults/SmallFileSystem.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/series/defective/HostileDicom.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <thread>

namespace pacsFaultsTest {

using core::ErrorCode;
using Fault = test::FaultyWire::Fault;
} // namespace pacsFaultsTest

Q_DECLARE_METATYPE(pacsFaultsTest::Fault)
Q_DECLARE_METATYPE(core::ErrorCode)

namespace pacsFaultsTest {

namespace {

core::PacsNode at(core::PacsNode node, int port)
{
    node.port = port;
    return node;
}

} // namespace

/// What goes wrong between two machines: a sentence for each, and nothing half imported.
class PacsFaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void nodesAreRead();
    void nobodyThere();
    void wrongTitles();
    void serverThatIsNone();
    void silentServerIsGivenUp();
    void cancelledWhileItWaits();
    void refusedKind();
    void unknownSeries();
    void endsMidTransfer_data();
    void endsMidTransfer();
    void sendingEnds_data();
    void sendingEnds();
    void downloadGoesOn();
    void damagedFileIsFetchedAgain();
    void powerFailureIsNotBelieved();
    void fullDisk();
    void fileThatCannotGrow();
    void targetInUse();
    void objectsAreChecked();
    void filesThatAreNoneAreNotSent();

private:
    [[nodiscard]] QString target() const { return m_folder->filePath(QStringLiteral("got")); }
    [[nodiscard]] core::Result<core::Retrieved> get(const core::PacsNode& node,
        const QString& folder, const core::Progress& progress = core::Progress()) const
    {
        return core::retrieve(node,
            {.studyUid = m_series.studyUid, .seriesUid = m_series.seriesUid}, folder, {}, progress);
    }

    QTemporaryDir m_sent;
    test::SyntheticSeries m_series;
    QStringList m_files;
    std::unique_ptr<test::PacsServer> m_server; ///< holds the series
    std::unique_ptr<QTemporaryDir> m_folder = std::make_unique<QTemporaryDir>();
};

#define NEED_SERVER                                                                                \
    if (!m_server->absent().isEmpty())                                                             \
        QSKIP(qPrintable(m_server->absent()));                                                     \
    m_folder = std::make_unique<QTemporaryDir>()

void PacsFaultsTest::initTestCase()
{
    m_series.size = {96, 96, 9};
    m_files = test::writeSeries(m_series, m_sent.path());
    m_server = std::make_unique<test::PacsServer>(test::PacsServer::Program::Dcmqrscp);
    QVERIFY2(m_server->problem().isEmpty(), qPrintable(m_server->problem()));
    if (m_server->absent().isEmpty())
        VERIFY_DONE(core::sendFiles(m_server->node(), m_files, core::Progress()));
}

void PacsFaultsTest::nodesAreRead()
{
    const auto node = core::PacsNode::parse(QStringLiteral("A@B@fe80::1:4242"));
    QVERIFY(node.has_value());
    QCOMPARE(node->aeTitle, QStringLiteral("A@B"));
    QCOMPARE(node->host, QStringLiteral("fe80::1"));
    QCOMPARE(node->port, 4242);
    QCOMPARE(node->name(), QStringLiteral("A@B@fe80::1:4242"));
    for (const char* wrong : {"", "host:104", "@host:104", "AET@:104", "AET@host", "AET@host:0",
             "AET@host:70000", "AET@host:x", "SEVENTEEN_LETTERS@host:104", "BACK\\SLASH@host:104",
             "ÄRZTE@host:104", " @host:104"}) {
        VERIFY_ERROR(core::PacsNode::parse(QString::fromUtf8(wrong)), ErrorCode::InvalidField);
    }
}

void PacsFaultsTest::nobodyThere()
{
    const core::PacsNode nobody{.aeTitle = QStringLiteral("NOBODY"),
        .host = QStringLiteral("127.0.0.1"),
        .port = test::freePort(),
        .tls = {}};
    const auto answered = core::echoNode(nobody, core::Progress());
    VERIFY_ERROR(answered, ErrorCode::NodeUnreachable);
    QCOMPARE(ui::errorText(answered.error()),
        QStringLiteral("NOBODY@127.0.0.1:%1 cannot be reached: Connection refused")
            .arg(nobody.port));
}

void PacsFaultsTest::wrongTitles()
{
    NEED_SERVER;
    core::PacsNode node = m_server->node();
    node.aeTitle = QStringLiteral("SOMEBODY");
    const auto answered = core::echoNode(node, core::Progress());
    VERIFY_ERROR(answered, ErrorCode::NodeRejects);
    QVERIFY2(ui::errorText(answered.error())
                 .endsWith(QLatin1String("does not talk to us: it is not called SOMEBODY")),
        qPrintable(ui::errorText(answered.error())));

    test::PacsServer orthanc(test::PacsServer::Program::Orthanc);
    if (!orthanc.absent().isEmpty())
        QSKIP(qPrintable(orthanc.absent()));
    QVERIFY2(orthanc.problem().isEmpty(), qPrintable(orthanc.problem()));
    node = orthanc.node();
    node.ownAeTitle = QStringLiteral("STRANGER");
    const auto refused = core::echoNode(node, core::Progress());
    QVERIFY(!refused.has_value());
    QVERIFY2(refused.error().code == ErrorCode::NodeRejects
            && refused.error().arguments.value(1).contains(QLatin1String("STRANGER")),
        qPrintable(ui::errorText(refused.error())));
}

void PacsFaultsTest::serverThatIsNone()
{
    NEED_SERVER;
    const test::FaultyWire wire(m_server->node().port, Fault::Garbage, 0);
    const auto answered = core::echoNode(at(m_server->node(), wire.port()), core::Progress());
    VERIFY_ERROR(answered, ErrorCode::NodeNonsense);
}

void PacsFaultsTest::silentServerIsGivenUp()
{
    NEED_SERVER;
    const test::FaultyWire wire(m_server->node().port, Fault::Stall, 0);
    core::PacsNode node = at(m_server->node(), wire.port());
    node.timeoutSeconds = 1;
    const auto answered = core::echoNode(node, core::Progress());
    VERIFY_ERROR(answered, ErrorCode::NodeTimeout);
    QVERIFY(ui::errorText(answered.error()).contains(QLatin1String("1 s without a sign of life")));
}

void PacsFaultsTest::cancelledWhileItWaits()
{
    NEED_SERVER;
    const test::FaultyWire wire(m_server->node().port, Fault::Stall, 20000);
    core::PacsNode node = at(m_server->node(), wire.port());
    node.timeoutSeconds = 600;
    core::Progress progress;
    std::thread impatient([&progress] {
        QTest::qSleep(300);
        progress.cancel();
    });
    const auto got = get(node, target(), progress);
    impatient.join();
    VERIFY_ERROR(got, ErrorCode::Cancelled);
    QVERIFY(!QFileInfo::exists(target()));
}

void PacsFaultsTest::refusedKind()
{
    NEED_SERVER;
    test::SyntheticSeries odd;
    odd.size = {8, 8, 1};
    odd.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SOPClassUID, "1.2.3.4.5");
        set.putAndInsertString(DCM_SOPInstanceUID, "2.25.90");
    };
    const QStringList files = test::writeSeries(odd, m_folder->path());
    const auto sent = core::sendFiles(m_server->node(), files, core::Progress());
    VERIFY_ERROR(sent, ErrorCode::NodeRefuses);
    QVERIFY(ui::errorText(sent.error()).endsWith(QLatin1String("does not support 1.2.3.4.5")));
}

void PacsFaultsTest::unknownSeries()
{
    NEED_SERVER;
    const auto study = core::retrieve(m_server->node(),
        {.studyUid = QStringLiteral("2.25.1"), .seriesUid = {}}, target(), {}, core::Progress());
    VERIFY_ERROR(study, ErrorCode::NodeHasNone);
    const auto series = core::retrieve(m_server->node(),
        {.studyUid = m_series.studyUid, .seriesUid = QStringLiteral("2.25.1")}, target(), {},
        core::Progress());
    VERIFY_ERROR(series, ErrorCode::NodeHasNone);
    QVERIFY(ui::errorText(series.error()).endsWith(QLatin1String("holds no such series")));
    QVERIFY(QDir(m_folder->path()).isEmpty());
}

void PacsFaultsTest::endsMidTransfer_data()
{
    QTest::addColumn<Fault>("fault");
    QTest::addColumn<int>("afterBytes");
    QTest::addColumn<ErrorCode>("expected");
    QTest::newRow("dies amid the pixels") << Fault::Cut << 70000 << ErrorCode::NodeLost;
    QTest::newRow("dies while it lists") << Fault::Cut << 700 << ErrorCode::NodeLost;
    QTest::newRow("is silent amid the pixels") << Fault::Stall << 70000 << ErrorCode::NodeTimeout;
    QTest::newRow("talks nonsense amid the pixels")
        << Fault::Garbage << 70000 << ErrorCode::NodeNonsense;
}

void PacsFaultsTest::endsMidTransfer()
{
    NEED_SERVER;
    QFETCH(Fault, fault);
    QFETCH(int, afterBytes);
    QFETCH(ErrorCode, expected);
    const test::FaultyWire wire(m_server->node().port, fault, afterBytes);
    core::PacsNode node = at(m_server->node(), wire.port());
    node.timeoutSeconds = 2;
    const auto got = get(node, target());
    VERIFY_ERROR(got, expected);
    QVERIFY(!QFileInfo::exists(target()));
}

void PacsFaultsTest::sendingEnds_data()
{
    QTest::addColumn<Fault>("fault");
    QTest::addColumn<ErrorCode>("expected");
    QTest::newRow("dies") << Fault::Cut << ErrorCode::NodeLost;
    QTest::newRow("is silent") << Fault::Stall << ErrorCode::NodeTimeout;
}

void PacsFaultsTest::sendingEnds()
{
    NEED_SERVER;
    QFETCH(Fault, fault);
    QFETCH(ErrorCode, expected);
    // It has accepted the association by then, and an object or two.
    const test::FaultyWire wire(m_server->node().port, fault, 500);
    core::PacsNode node = at(m_server->node(), wire.port());
    node.timeoutSeconds = 2;
    int sent = 0;
    const core::Progress progress([&sent](core::ProgressStep, int done, int) { sent = done; });
    const auto result = core::sendFiles(node, m_files, progress);
    VERIFY_ERROR(result, expected);
    QVERIFY(sent > 0);
    QVERIFY(sent < int(m_files.size()));
}

void PacsFaultsTest::downloadGoesOn()
{
    NEED_SERVER;
    {
        // Three and a half of nine, of 18 KB each.
        const test::FaultyWire wire(m_server->node().port, Fault::Cut, 70000);
        QVERIFY(!get(at(m_server->node(), wire.port()), target()).has_value());
    }
    QStringList told;
    const core::Progress progress([&told](core::ProgressStep, int done, int total) {
        told.append(QStringLiteral("%1/%2").arg(done).arg(total));
    });
    const auto got = get(m_server->node(), target(), progress);
    VERIFY_DONE(got);
    QVERIFY(got->kept > 0);
    QCOMPARE(told.size(), got->received);
    QCOMPARE(told.back(), QStringLiteral("%1/%1").arg(got->received));
    QCOMPARE(got->kept + got->received, int(m_files.size()));
    QCOMPARE(QDir(target()).entryList(QDir::Files | QDir::Hidden).size(), m_files.size());
}

void PacsFaultsTest::damagedFileIsFetchedAgain()
{
    NEED_SERVER;
    {
        const test::FaultyWire wire(m_server->node().port, Fault::Cut, 70000);
        QVERIFY(!get(at(m_server->node(), wire.port()), target()).has_value());
    }
    QDir gathering(m_folder->path());
    QVERIFY(gathering.cd(QStringLiteral(".got.burin-download")));
    const QStringList here = gathering.entryList(QDir::Files);
    QVERIFY(here.size() > 1);
    QVERIFY(QFile::resize(gathering.filePath(here.front()), 9000));
    const auto got = get(m_server->node(), target());
    VERIFY_DONE(got);
    QCOMPARE(got->kept, int(here.size()) - 1);
}

void PacsFaultsTest::powerFailureIsNotBelieved()
{
    NEED_SERVER;
    {
        const test::FaultyWire wire(m_server->node().port, Fault::Cut, 70000);
        QVERIFY(!get(at(m_server->node(), wire.port()), target()).has_value());
    }
    // As a download leaves it that the system's end took with it.
    QFile note(m_folder->filePath(QStringLiteral(".got.burin-download/.download")));
    QVERIFY(note.open(QIODevice::ReadWrite));
    QCOMPARE(note.readAll(), QByteArray("on disk"));
    QVERIFY(note.resize(0));
    note.write("another start of the system");
    note.close();
    const auto got = get(m_server->node(), target());
    VERIFY_DONE(got);
    QCOMPARE(got->kept, 0);
    QCOMPARE(got->received, int(m_files.size()));
}

void PacsFaultsTest::fullDisk()
{
    NEED_SERVER;
    test::SmallFileSystem disk(100);
    if (!disk.problem().isEmpty())
        QSKIP(qPrintable(disk.problem()));
    const QString folder = disk.filePath(QStringLiteral("got"));
    const auto got = get(m_server->node(), folder);
    VERIFY_ERROR(got, ErrorCode::FileUnwritable);
    QCOMPARE(got.error().arguments.value(0), folder);
    QVERIFY2(got.error().arguments.value(1).contains(QLatin1String("No space left")),
        qPrintable(ui::errorText(got.error())));
    QVERIFY(!QFileInfo::exists(folder));
    disk.resize(1000);
    const auto rest = get(m_server->node(), folder);
    VERIFY_DONE(rest);
    QVERIFY(rest->kept > 0);
}

void PacsFaultsTest::fileThatCannotGrow()
{
    NEED_SERVER;
    const test::FileSizeLimit limit(5000);
    const auto got = get(m_server->node(), target());
    VERIFY_ERROR(got, ErrorCode::FileUnwritable);
    // Nothing came, nothing stays.
    QVERIFY(QDir(m_folder->path())
                .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
                .isEmpty());
}

void PacsFaultsTest::targetInUse()
{
    NEED_SERVER;
    QVERIFY(QDir().mkpath(target()));
    const QString other = target() + QStringLiteral("/notes.txt");
    QVERIFY(QFile::copy(m_files.front(), other));
    VERIFY_ERROR(get(m_server->node(), target()), ErrorCode::FileUnwritable);
    QCOMPARE(QDir(target()).entryList(QDir::Files), QStringList{QStringLiteral("notes.txt")});
    QVERIFY(QFile::remove(other));
    // Another download that goes there.
    const auto first = core::DownloadFolder::open(target());
    VERIFY_DONE(first);
    VERIFY_ERROR(get(m_server->node(), target()), ErrorCode::FileUnwritable);
}

void PacsFaultsTest::objectsAreChecked()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QFile honest(m_files.front());
    QVERIFY(honest.open(QIODevice::ReadOnly));
    DcmFileFormat format;
    QVERIFY(format.loadFile(m_files.front().toUtf8().constData()).good());
    OFString text;
    QVERIFY(format.getDataset()->findAndGetOFString(DCM_SOPInstanceUID, text).good());
    const QString uid = QString::fromLatin1(text.c_str());
    VERIFY_DONE(core::checkObject(m_files.front(), uid));
    VERIFY_ERROR(core::checkObject(m_files.front(), uid + u'1'), ErrorCode::FileUnreadable);
    int refused = 0;
    for (const test::HostileDicom& hostile : test::hostileDicoms(honest.readAll())) {
        const QString path = m_folder->filePath(QStringLiteral("hostile.dcm"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(hostile.bytes);
        file.close();
        if (hostile.onlyWhenDecoded)
            continue;
        QVERIFY2(!core::checkObject(path, uid).has_value(), hostile.name);
        ++refused;
    }
    QVERIFY(refused > 5);
    // What a node calls an object is no path.
    const auto folder = core::DownloadFolder::open(target());
    VERIFY_DONE(folder);
    for (const char* name : {"../../evil", "/etc/passwd", "", ".", "..", "1.2.3/../../4"}) {
        const QFileInfo info(folder->pathOf(QString::fromLatin1(name)));
        QCOMPARE(info.absolutePath(), m_folder->filePath(QStringLiteral(".got.burin-download")));
        QCOMPARE(info.fileName().size(), 68);
    }
}

void PacsFaultsTest::filesThatAreNoneAreNotSent()
{
    m_folder = std::make_unique<QTemporaryDir>();
    const QString path = m_folder->filePath(QStringLiteral("notes.txt"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not a DICOM file, however long it may be");
    file.close();
    const core::PacsNode nobody{.aeTitle = QStringLiteral("NOBODY"),
        .host = QStringLiteral("127.0.0.1"),
        .port = test::freePort(),
        .tls = {}};
    // Before anybody is asked.
    VERIFY_ERROR(core::sendFiles(nobody, {path}, core::Progress()), ErrorCode::UnsupportedFormat);
}

BURIN_TEST(PacsFaultsTest)

} // namespace pacsFaultsTest

#include "PacsFaultsTest.moc"

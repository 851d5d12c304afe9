// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "app/window/PrivateSettings.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/export/common/ExportFormats.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/Python.h"
#include "tests/support/servers/WebArchive.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/panels/lists/MeasurementsPanel.h"
#include "ui/report/AuditSaver.h"
#include "ui/window/MainWindow.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLineEdit>
#include <QMap>
#include <QMessageBox>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <array>
#include <csignal>

namespace filesWrittenUiTest {

using test::FileEvent;
using test::key;
using test::Outcome;

namespace {

/// Names the folder for driven().
constexpr const char* drivenIn = "BURIN_DRIVEN_IN";
/// What it writes there.
constexpr std::array drivenFiles{"driven.burin", "driven.dcm", "driven.nii.gz", "driven.stl",
    "driven.csv", "driven.html", "driven.pdf", "driven.png", "measured.csv"};

/// What a file is known by, without its bytes.
using Stamp = std::pair<qint64, qint64>;

QMap<QString, Stamp> everythingIn(const QString& folder)
{
    QMap<QString, Stamp> all;
    QDirIterator walk(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
        QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QFileInfo info(walk.next());
        const bool isFolder = info.isDir() && !info.isSymLink();
        all[info.filePath()] =
            isFolder ? Stamp{-1, 0} : Stamp{info.size(), info.lastModified().toMSecsSinceEpoch()};
    }
    return all;
}

QString companionsOwner(QString path)
{
    for (const char* ending : {"-wal", "-shm", "-journal"}) {
        if (path.endsWith(QLatin1String(ending)))
            return path.chopped(int(qstrlen(ending)));
    }
    return path;
}

} // namespace

/// Every file that the command line and its window open for writing, rename, replace or remove is
/// one of the kinds named here. Whatever else is written is found here first: it goes through
/// core/base/files/StagedFile, or its kind gets a name and a reason.
class FilesWrittenUiTest : public QObject {
    Q_OBJECT

    test::WatchedHome m_home;
    QString m_work; ///< what commands are told to write lies here
    QString m_study;

    QString at(const char* name) const { return QDir(m_work).filePath(QLatin1String(name)); }
    QString text(const char* name, const QJsonObject& content) const
    {
        QFile file(at(name));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("cannot write %s", name);
        file.write(QJsonDocument(content).toJson());
        return file.fileName();
    }
    static QJsonArray edits();
    QJsonArray exports(bool deidentified) const;
    QStringList exportedFiles() const;

    /// What a thing that was done to the file system is; empty: nothing that is known.
    QString kindOf(const FileEvent& event, const QStringList& targets, bool newSession) const;
    bool isStaged(const QString& path, const QStringList& targets) const;
    /// Where a download gathers what is to be one of the targets, and its lock.
    static bool isGathered(const QString& path, const QStringList& targets);
    /// Fails the test with what is of no known kind, or was done without the shim seeing it.
    void judge(const char* command, const QStringList& targets, bool newSession);
    void carryOut(
        const char* name, const QStringList& words, const QStringList& targets, bool newSession);

    QMap<QString, Stamp> m_before;
    QMap<QString, int> m_kinds;
    QSet<QString>
        m_placed; ///< took their name in the command that is judged: then they are its own

private Q_SLOTS:
    void initTestCase();
    void sessionsAndExports();
    void replays();
    void everyFormatOverWhatIsThere();
    void batches();
    void histories();
    void masksAndStudies();
    void servers();
    void windows();
    void windowsOwnDialogs();
    void driven();
    void cleanupTestCase();
};

QJsonArray FilesWrittenUiTest::edits()
{
    const QJsonArray code{key("SCT"), key("10200004"), key("Liver")};
    return {QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Liver")},
                {key("color"), key("#336699")}, {key("code"), code}},
        QJsonObject{{key("edit"), key("drill")},
            {key("view"),
                QJsonObject{{key("eyeLps"), QJsonArray{0, -300, 50}},
                    {key("targetLps"), QJsonArray{0, 0, 50}}, {key("up"), QJsonArray{0, 0, 1}},
                    {key("heightMm"), 60}, {key("orthographic"), true}}},
            {key("mask"), QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), 4}}},
            {key("depthMm"), 6}, {key("surface"), QJsonObject{{key("threshold"), -2000}}},
            {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1.0, 0.0})}}},
        QJsonObject{{key("edit"), key("layerToSegment")}, {key("layer"), 1}, {key("segment"), 1}}};
}

QStringList FilesWrittenUiTest::exportedFiles() const
{
    QStringList files;
    for (const core::ExportFormatFacts& format : core::exportFormats()) {
        const QString name = QLatin1String(format.name);
        files +=
            QDir(m_work).filePath(QStringLiteral("out/") + name + QLatin1String(format.ending));
        if (format.format == core::ExportFormat::Sr)
            files += QDir(m_work).filePath(QStringLiteral("out/sr-seg.dcm"));
    }
    return files
        + QStringList{at("out/coverage.nii.gz"), at("out/carved.nii.gz"), at("out/series")};
}

QJsonArray FilesWrittenUiTest::exports(bool deidentified) const
{
    QJsonArray all;
    for (const core::ExportFormatFacts& format : core::exportFormats()) {
        const QString name = QLatin1String(format.name);
        QJsonObject one{{key("format"), name},
            {key("file"),
                QDir(m_work).filePath(
                    QStringLiteral("out/") + name + QLatin1String(format.ending))}};
        if (deidentified)
            one[key("deidentify")] = true;
        all.append(one);
    }
    all.append(QJsonObject{{key("format"), key("coverage")}, {key("layer"), 1},
        {key("file"), at("out/coverage.nii.gz")}});
    all.append(
        QJsonObject{{key("format"), key("carved-volume")}, {key("file"), at("out/carved.nii.gz")}});
    if (!deidentified)
        all.append(
            QJsonObject{{key("format"), key("carved-volume")}, {key("file"), at("out/series")}});
    return all;
}

void FilesWrittenUiTest::initTestCase()
{
    m_work = m_home.path(QStringLiteral("work"));
    QVERIFY(QDir().mkpath(at("out")));
    m_study = at("ct");
    test::SyntheticSeries series;
    series.size = {24, 18, 10};
    test::writeSeries(series, m_study);
    m_before = everythingIn(m_home.path(QString()));
}

bool FilesWrittenUiTest::isStaged(const QString& path, const QStringList& targets) const
{
    static const QRegularExpression hidden(QStringLiteral("^\\.burin-[0-9a-f]{12}(\\..+)?$"));
    const QString owner = companionsOwner(path);
    for (const QString& target : targets) {
        const QDir folder = QFileInfo(target).dir();
        const QString inside = folder.relativeFilePath(owner);
        if (!inside.startsWith(QLatin1String(".."))
            && hidden.match(inside.section(QLatin1Char('/'), 0, 0)).hasMatch())
            return true;
    }
    return false;
}

bool FilesWrittenUiTest::isGathered(const QString& path, const QStringList& targets)
{
    return std::any_of(targets.begin(), targets.end(), [&path](const QString& target) {
        const QFileInfo info(target);
        const QString folder = info.dir().filePath(
            QLatin1Char('.') + info.fileName() + QStringLiteral(".burin-download"));
        return path == folder || path.startsWith(folder + QLatin1Char('/'))
            || path == folder + QStringLiteral(".lock");
    });
}

QString FilesWrittenUiTest::kindOf(
    const FileEvent& event, const QStringList& targets, bool newSession) const
{
    const QString& path = event.path;
    const bool renames = event.what == "rename" || event.what == "exchange";
    const auto isIn = [&path, this](const char* folder) {
        return path.startsWith(m_home.path(QLatin1String(folder)) + QLatin1Char('/'));
    };
    const QString shaders = qEnvironmentVariable("MESA_SHADER_CACHE_DIR");
    if (!shaders.isEmpty() && path.startsWith(shaders + QLatin1Char('/')))
        return QStringLiteral("Mesa's cache of shaders");
    const QString dialogs = m_home.path(QStringLiteral("config/QtProject.conf"));
    if (path == dialogs || path == dialogs + QStringLiteral(".lock")
        || (event.what == "unnamed" && path == m_home.path(QStringLiteral("config")))
        || (event.what == "link" && event.more.startsWith(dialogs))
        || (event.what == "rename" && event.more == dialogs))
        return QStringLiteral("which folders Qt's dialogs showed");
    // Qt writes settings into a file without a name, and then gives it one.
    if (event.what == "link")
        return event.more.startsWith(m_home.path(QStringLiteral("config/burin/")))
            ? QStringLiteral("settings")
            : QString();
    if (isGathered(path, targets)
        && (!renames || isGathered(event.more, targets) || targets.contains(event.more)))
        return QStringLiteral("a download, gathered beside its target");
    if (renames && isStaged(path, targets) && isStaged(event.more, targets))
        return QStringLiteral("staged beside its target");
    if (renames)
        return isStaged(path, targets) && targets.contains(event.more)
            ? QStringLiteral("a target takes its name")
            : isIn("cache") || isIn("config")
            ? QStringLiteral("a cache or settings take their name")
            : QString();
    if (isStaged(path, targets))
        return QStringLiteral("staged beside its target");
    if (event.what == "open" && path.endsWith(QLatin1String("/lock")) && targets.contains(path))
        return QStringLiteral("the lock of a study's results, which a batch holds");
    const auto isInside = [&path](const QString& target) {
        return target.startsWith(path + QLatin1Char('/'));
    };
    if (event.what == "make" && std::any_of(targets.begin(), targets.end(), isInside))
        return QStringLiteral("the folder of a target");
    if (targets.contains(companionsOwner(path)) && path.contains(key(".burin"))
        && (newSession || m_placed.contains(companionsOwner(path))))
        return QStringLiteral("a session, new or its own");
    static const std::initializer_list<std::pair<const char*, const char*>> places{
        {"state/burin", "working sessions"}, {"config/burin", "settings"},
        {"cache/burin", "caches of Burin"}, {"cache/mesa_shader_cache", "Mesa's cache of shaders"},
        {"cache/mesa_shader_cache_db", "Mesa's cache of shaders"},
        {"cache/fontconfig", "fontconfig's cache"}, {"tmp", "for a while, in a private folder"}};
    for (const auto& [folder, kind] : places) {
        if (isIn(folder) || path == m_home.path(QLatin1String(folder)))
            return QLatin1String(kind);
    }
    if (path == QLatin1String("/dev/null") || path.startsWith(QLatin1String("/dev/dri/")))
        return QStringLiteral("a device");
    return {};
}

void FilesWrittenUiTest::judge(const char* command, const QStringList& targets, bool newSession)
{
    const std::vector<FileEvent> events = m_home.events();
    QSet<QString> told{m_home.path(QStringLiteral("shim.log"))};
    QStringList unknown;
    m_placed.clear();
    for (const FileEvent& event : events) {
        told += event.path;
        if (event.what == "rename" || event.what == "exchange" || event.what == "link")
            told += event.more;
        const QString kind = kindOf(event, targets, newSession);
        if (event.what == "exchange" || event.what == "rename")
            m_placed += event.more;
        ++m_kinds[kind];
        if (kind.isEmpty())
            unknown += QString::fromLatin1(event.what) + QLatin1Char(' ') + event.path
                + QLatin1Char(' ') + event.more;
    }
    QVERIFY2(unknown.isEmpty(),
        qPrintable(QLatin1String(command) + QStringLiteral(" does what nobody allowed:\n")
            + unknown.join(QLatin1Char('\n'))));
    // The shim sees all of it, or this test proves nothing.
    const QMap<QString, Stamp> after = everythingIn(m_home.path(QString()));
    QStringList unseen;
    for (auto file = after.begin(); file != after.end(); ++file) {
        const bool inSeries = file.key().startsWith(at("out/series") + QLatin1Char('/'))
            || file.key().startsWith(at("demo") + QLatin1Char('/'))
            || file.key().startsWith(at("got") + QLatin1Char('/'));
        const bool inRenamed = file.key().contains(QLatin1String("/cache/burin/"));
        if (m_before.value(file.key(), {-2, 0}) != file.value() && !told.contains(file.key())
            && !inSeries && !inRenamed)
            unseen += file.key();
    }
    for (auto file = m_before.begin(); file != m_before.end(); ++file) {
        if (!after.contains(file.key()) && !told.contains(file.key()))
            unseen += file.key();
    }
    QVERIFY2(unseen.isEmpty(),
        qPrintable(QLatin1String(command) + QStringLiteral(" changed, without being seen: ")
            + unseen.join(QLatin1Char(' '))));
    m_before = after;
}

void FilesWrittenUiTest::carryOut(
    const char* name, const QStringList& words, const QStringList& targets, bool newSession)
{
    m_before = everythingIn(m_home.path(QString()));
    const Outcome outcome = m_home.burin(words);
    QVERIFY2(outcome.status == 0, qPrintable(QLatin1String(name) + outcome.complaint));
    judge(name, targets, newSession);
}

#define CARRY_OUT(...)                                                                             \
    carryOut(__VA_ARGS__);                                                                         \
    if (QTest::currentTestFailed())                                                                \
    return

void FilesWrittenUiTest::sessionsAndExports()
{
    const QString recipe =
        text("r.json", {{key("edits"), edits()}, {key("export"), exports(false)}});
    const QString session = at("a.burin");
    const QStringList words{key("run"), recipe, key("--study"), m_study, key("--session"), session};
    CARRY_OUT("run", words, exportedFiles() + QStringList{session}, true);
    QVERIFY(QDir(at("out/series")).removeRecursively());
    CARRY_OUT("run --force", words + QStringList{key("--force")},
        exportedFiles() + QStringList{session}, false);
    const QJsonArray few{QJsonObject{{key("format"), key("csv")}, {key("file"), at("more.csv")}}};
    const QString more =
        text("more.json", {{key("edits"), QJsonArray{edits()[1]}}, {key("export"), few}});
    CARRY_OUT("run --append", {key("run"), more, key("--session"), session, key("--append")},
        {session, at("more.csv")}, true);
    CARRY_OUT("run --with-images",
        {key("run"), text("plain.json", {{key("edits"), edits()}}), key("--study"), m_study,
            key("--session"), at("b.burin"), key("--with-images")},
        {at("b.burin")}, true);
    CARRY_OUT("run --trace",
        {key("run"), at("plain.json"), key("--study"), m_study, key("--session"), at("t.burin"),
            key("--trace"), at("t.json")},
        {at("t.burin"), at("t.json")}, true);
}

void FilesWrittenUiTest::replays()
{
    CARRY_OUT("replay", {key("replay"), at("a.burin"), key("--verify")}, {}, false);
}

void FilesWrittenUiTest::everyFormatOverWhatIsThere()
{
    for (const core::ExportFormatFacts& format : core::exportFormats()) {
        const QString name = QLatin1String(format.name);
        const QString file =
            QDir(m_work).filePath(QStringLiteral("out/") + name + QLatin1String(format.ending));
        QVERIFY(QFile::exists(file));
        QStringList words{key("replay"), at("a.burin"), key("--export"), file, key("--format"),
            name, key("--force")};
        if (format.namesSourceImages)
            words += key("--deidentify");
        CARRY_OUT(format.name, words, {file, at("out/sr-seg.dcm")}, false);
    }
    CARRY_OUT("coverage",
        {key("replay"), at("a.burin"), key("--export"), at("out/coverage.nii.gz"), key("--format"),
            key("coverage"), key("--layer"), key("1"), key("--force")},
        {at("out/coverage.nii.gz")}, false);
    CARRY_OUT("carved-volume",
        {key("replay"), at("a.burin"), key("--export"), at("out/carved.nii.gz"), key("--format"),
            key("carved-volume"), key("--force")},
        {at("out/carved.nii.gz")}, false);
}

void FilesWrittenUiTest::batches()
{
    QFile list(at("list.csv"));
    QVERIFY(list.open(QIODevice::WriteOnly));
    list.write("study,name,session\nct,one,one.burin\nct,two,two.burin\n");
    list.close();
    const QJsonArray mask{
        QJsonObject{{key("format"), key("nifti")}, {key("file"), key("m.nii.gz")}}};
    const QString recipe = text("each.json", {{key("edits"), edits()}, {key("export"), mask}});
    QStringList targets{at("batch/results.csv")};
    for (const char* study : {"one", "two"}) {
        const QString folder = at("batch/") + QLatin1String(study) + QLatin1Char('/');
        for (const char* file : {"lock", "record.json", "recipe.json", "m.nii.gz"})
            targets += folder + QLatin1String(file);
        targets += folder + QLatin1String(study) + key(".burin");
    }
    const QStringList words{
        key("batch"), recipe, key("--studies"), list.fileName(), key("--into"), at("batch")};
    CARRY_OUT("batch", words, targets, false);
    CARRY_OUT("batch, again", words, targets, false);
}

void FilesWrittenUiTest::histories()
{
    CARRY_OUT("history --json", {key("history"), at("a.burin"), key("--json")}, {}, false);
    for (const char* report : {"report.html", "report.pdf"}) {
        for (const char* force : {"", "--force"}) {
            QStringList words{key("history"), at("a.burin"), key("--report"), at(report)};
            if (*force != '\0')
                words += key(force);
            CARRY_OUT("history --report", words, {at(report)}, false);
        }
    }
    for (const char* force : {"", "--force"}) {
        QStringList words{key("history"), at("a.burin"), key("--deidentified"), at("shared.burin")};
        if (*force != '\0')
            words += key(force);
        CARRY_OUT("history --deidentified", words, {at("shared.burin")}, false);
    }
}

void FilesWrittenUiTest::masksAndStudies()
{
    const QString mask = at("out/nifti.nii.gz");
    for (const char* force : {"", "--force"}) {
        QStringList words{key("mesh"), mask, key("--study"), m_study, key("--out"), at("m.stl"),
            key("--vertices"), key("400")};
        if (*force != '\0')
            words += key(force);
        CARRY_OUT("mesh", words, {at("m.stl")}, false);
    }
    CARRY_OUT("compare", {key("compare"), mask, mask, key("--study"), m_study}, {}, false);
    CARRY_OUT("info", {key("info"), m_study}, {}, false);
    CARRY_OUT("edits", {key("edits")}, {}, false);
    CARRY_OUT("demo", {key("demo"), at("demo")}, {at("demo")}, false);
    const auto packed = test::runProgram(QStringLiteral("/usr/bin/python3"),
        {key("-m"), key("zipfile"), key("-c"), at("ct.zip"), m_study});
    QCOMPARE(packed.exitCode, 0);
    CARRY_OUT("info of an archive", {key("info"), at("ct.zip")}, {}, false);
    CARRY_OUT("run of an archive",
        {key("run"), at("plain.json"), key("--study"), at("ct.zip"), key("--session"),
            at("z.burin")},
        {at("z.burin")}, true);
    core::DivideSegment division{.segment = 1, .marginMm = 3.0};
    division.probabilityFile = mask; // whose labels are 0 and 1
    const QString reads = text("reads.json",
        {{key("edits"),
            test::toJson({core::Edit(core::ImportMask{.file = mask}), core::Edit(division)})}});
    CARRY_OUT("run with masks",
        {key("run"), reads, key("--study"), m_study, key("--session"), at("i.burin")},
        {at("i.burin")}, true);
}

void FilesWrittenUiTest::servers()
{
    QStringList files;
    for (const QFileInfo& file : QDir(m_study).entryInfoList(QDir::Files))
        files += file.filePath();
    const test::WebArchive archive(files);
    const test::WebServer server(
        [&archive](const QByteArray& line, const QByteArray&) { return archive.answer(line); });
    const QString address = server.url().toString();
    const QString study = QString::fromLatin1(archive.studyUid());
    CARRY_OUT("echo", {key("echo"), address}, {}, false);
    CARRY_OUT("find", {key("find"), address, key("--study"), study}, {}, false);
    const QStringList words{key("get"), address, key("--study"), study, key("--to"), at("got")};
    CARRY_OUT("get", words, {at("got")}, false);
    QCOMPARE(QDir(at("got")).entryList(QDir::Files).size(), files.size());
    CARRY_OUT("get, again", words, {}, false);
    CARRY_OUT("send", {key("send"), address, m_study}, {}, false);
}

void FilesWrittenUiTest::windows()
{
    for (const char* picture : {"p.png", "p.dcm"})
        CARRY_OUT("open --screenshot", {key("open"), m_study, key("--screenshot"), at(picture)},
            {at(picture)}, false);
    CARRY_OUT("open --trace",
        {key("open"), key("--screenshot"), at("start.png"), key("--trace"), at("trace.json")},
        {at("start.png"), at("trace.json")}, false);
    // A session is open in the window, and the window is told to end.
    QProcess process;
    process.setProcessEnvironment(m_home.environment());
    m_before = everythingIn(m_home.path(QString()));
    process.start(QStringLiteral(BURIN_PROGRAM), {key("open"), at("a.burin")});
    QElapsedTimer waited;
    waited.start();
    while (!QFile::exists(at("a.burin-wal")) && waited.elapsed() < 60000
        && !process.waitForFinished(50)) { }
    QVERIFY(process.state() == QProcess::Running);
    ::kill(pid_t(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 128 + SIGTERM);
    judge("open", {at("a.burin")}, true);
}

/// A window in which a user saves the session under another name, exports, reports and takes a
/// picture, with every file new and once more over what is there.
void FilesWrittenUiTest::windowsOwnDialogs()
{
    QStringList targets;
    for (const char* name : drivenFiles)
        targets += at(name);
    for (const QString& target : std::as_const(targets))
        QVERIFY(!QFile::exists(target));
    for (int time = 0; time < 2; ++time) {
        QProcess process;
        QProcessEnvironment environment = m_home.environment();
        environment.insert(key(drivenIn), m_work);
        environment.insert(key("BURIN_TEST_DISPLAY"), key("inherit"));
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        m_before = everythingIn(m_home.path(QString()));
        process.start(
            QCoreApplication::applicationFilePath(), {key("FilesWrittenUiTest"), key("driven")});
        QVERIFY(process.waitForFinished(test::ApplicationFixture::patience));
        QVERIFY2(process.exitCode() == 0, process.readAll().constData());
        judge("a driven window", targets + QStringList{at("a.burin")}, true);
        if (QTest::currentTestFailed())
            return;
        for (const QString& target : std::as_const(targets))
            QVERIFY2(QFile::exists(target), qPrintable(target));
    }
    const QFile::Permissions others =
        QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    const QString dialogs = m_home.path(QStringLiteral("config/QtProject.conf"));
    QVERIFY(QFileInfo(dialogs).size() > 0);
    QVERIFY(!(QFile::permissions(dialogs) & others));
}

/// What windowsOwnDialogs() watches, in a program of its own.
void FilesWrittenUiTest::driven()
{
    if (!qEnvironmentVariableIsSet(drivenIn))
        QSKIP("windowsOwnDialogs() starts it");
    const QDir work(qEnvironmentVariable(drivenIn));
    const auto in = [&work](const char* name) { return work.filePath(QLatin1String(name)); };
    constexpr int patience = test::ApplicationFixture::patience;
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    // Where settings lie.
    QCoreApplication::setApplicationName(key("burin"));
    QCoreApplication::setOrganizationName(key("burin"));
    app::keepSettingsPrivate();
    const std::unique_ptr<app::Application> application = *app::Application::create();
    ui::MainWindow& window = application->window();
    ui::Workspace& workspace = application->workspace();
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.opener().open(in("a.burin"));
    QTRY_VERIFY_WITH_TIMEOUT(workspace.session(), patience);

    QString wanted;
    const test::Dialogs dialogs([&wanted](QWidget& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            for (QAbstractButton* button : box->buttons()) {
                if (box->buttonRole(button) != QMessageBox::RejectRole
                    && box->buttonRole(button) != QMessageBox::NoRole)
                    return button->click();
            }
        }
        if (auto* choice = qobject_cast<QFileDialog*>(&dialog)) {
            choice->findChild<QLineEdit*>()->setText(wanted);
            QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
        }
    });
    wanted = in("driven.burin");
    QSignalSpy saved(&workspace, &ui::Workspace::sessionSaved);
    window.saveSessionAs();
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, patience);

    const std::pair<const char*, core::ExportFormat> formats[] = {
        {"driven.dcm", core::ExportFormat::DicomSeg}, {"driven.nii.gz", core::ExportFormat::Nifti},
        {"driven.stl", core::ExportFormat::Stl}, {"driven.csv", core::ExportFormat::Csv}};
    for (const auto& [name, format] : formats) {
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
        ui::ExportDialog* dialog = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((dialog = window.findChild<ui::ExportDialog*>()), patience);
        auto* choice = dialog->findChild<QComboBox*>(key("exportFormat"));
        choice->setCurrentIndex(choice->findData(int(format)));
        dialog->findChild<QLineEdit*>(key("exportFile"))->setText(in(name));
        QSignalSpy exported(dialog, &ui::ExportDialog::exported);
        dialog->findChild<QAbstractButton*>(key("exportStart"))->click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, patience);
        delete dialog;
    }
    auto* reports = window.findChild<ui::AuditSaver*>();
    QSignalSpy reported(reports, &ui::AuditSaver::saved);
    for (const char* name : {"driven.html", "driven.pdf"}) {
        reported.clear();
        reports->save(in(name));
        QTRY_COMPARE_WITH_TIMEOUT(reported.count(), 1, patience);
    }
    wanted = in("driven.png");
    QVERIFY(!ui::askAndSavePicture(workspace, window).isEmpty());
    window.findChild<ui::MeasurementsPanel*>()->saveAs(in("measured.csv"));
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(in("measured.csv")), patience);
}

void FilesWrittenUiTest::cleanupTestCase()
{
    for (auto kind = m_kinds.begin(); kind != m_kinds.end(); ++kind)
        qInfo("%5d %s", kind.value(), qPrintable(kind.key()));
}

BURIN_WINDOW_TEST(FilesWrittenUiTest)

} // namespace filesWrittenUiTest

#include "FilesWrittenUiTest.moc"

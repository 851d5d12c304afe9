// SPDX-License-Identifier: Apache-2.0
#include "tests/support/StormStage.h"

#include "core/pacs/DownloadFolder.h"
#include "core/session/SessionSalvage.h"
#include "tests/support/CommandFixture.h"
#include "tests/support/SyntheticSeries.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace test {

namespace {

QJsonObject drill(double x, double depthMm)
{
    return {{key("edit"), key("drill")},
        {key("view"),
            QJsonObject{{key("eyeLps"), QJsonArray{x, -300, 50}},
                {key("targetLps"), QJsonArray{x, 0, 50}}, {key("up"), QJsonArray{0, 0, 1}},
                {key("heightMm"), 60}, {key("orthographic"), true}}},
        {key("mask"), QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), 3}}},
        {key("depthMm"), depthMm}, {key("surface"), QJsonObject{{key("threshold"), -2000}}},
        {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1.0, 0.0})}}};
}

/// A segment of what is drilled.
QJsonArray edits(double depthMm)
{
    const QJsonArray code{key("SCT"), key("10200004"), key("Liver")};
    return {QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Liver")},
                {key("color"), key("#336699")}, {key("code"), code}},
        drill(-4, depthMm), drill(0, depthMm), drill(4, depthMm),
        QJsonObject{{key("edit"), key("layerToSegment")}, {key("layer"), 1}, {key("segment"), 1}}};
}

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// A folder is told by how many sound images it holds.
QByteArray contentOf(const QString& path)
{
    if (!QFileInfo(path).isDir())
        return read(path);
    int sound = 0;
    for (const QString& name : QDir(path).entryList(QDir::Files))
        sound += core::soundObject(QDir(path).filePath(name)) ? 1 : 0;
    return QByteArray::number(sound) + " of "
        + QByteArray::number(QDir(path).entryList(QDir::Files).size());
}

bool isSessionName(const QString& path)
{
    return path.endsWith(QLatin1String(".burin"));
}

} // namespace

StormStage::StormStage(const WatchedHome& home)
    : m_home(home)
    , m_study(home.path(QStringLiteral("ct")))
{
    SyntheticSeries series;
    series.size = {24, 18, 8};
    writeSeries(series, m_study);
    if (!QDir().mkpath(folder()))
        qFatal("no folder");
    makeOld();
    const QString session = at("a.burin");
    const auto exports = [this](const char* names) {
        QJsonArray all;
        const auto add = [&](const char* format, const char* ending) {
            all.append(QJsonObject{{key("format"), key(format)},
                {key("file"), at("") + QLatin1String(names) + QLatin1String(ending)}});
        };
        add("nifti", ".nii.gz");
        add("seg-nrrd", ".seg.nrrd");
        add("obj", ".obj");
        add("csv", ".csv");
        add("dicom-seg", ".dcm");
        add("sr", "-sr.dcm");
        return all;
    };
    const auto filesOf = [this](const char* names) {
        QStringList all;
        for (const char* ending :
            {".nii.gz", ".seg.nrrd", ".obj", ".csv", ".dcm", "-sr.dcm", "-sr-seg.dcm"})
            all += at("") + QLatin1String(names) + QLatin1String(ending);
        return all;
    };
    const auto run = [&](const char* name, const QJsonObject& recipe, const QStringList& more) {
        return QStringList{key("run"), text(name, recipe)} + more;
    };
    const QStringList ofStudy{key("--study"), m_study};
    addScene({.name = "run --force",
        .words = run("new.json", {{key("edits"), edits(6)}, {key("export"), exports("x")}},
            ofStudy + QStringList{key("--session"), session, key("--force")}),
        .targets = filesOf("x") + QStringList{session},
        .session = session});
    addScene({.name = "run",
        .words = run("begun.json", {{key("edits"), edits(6)}, {key("export"), exports("y")}},
            ofStudy + QStringList{key("--session"), at("b.burin")}),
        .targets = filesOf("y") + QStringList{at("b.burin")},
        .session = at("b.burin")});
    addScene({.name = "run --append",
        .words = run("more.json",
            {{key("edits"), QJsonArray{drill(-2, 5), drill(2, 7), drill(6, 3)}},
                {key("export"), exports("z")}},
            {key("--session"), session, key("--append")}),
        .targets = filesOf("z") + QStringList{session},
        .session = session});
    addScene({.name = "replay --export",
        .words = {key("replay"), session, key("--export"), at("x.ply"), key("--force")},
        .targets = {at("x.ply")},
        .session = {}});
    addScene({.name = "carved series",
        .words = {key("replay"), session, key("--export"), at("series"), key("--format"),
            key("carved-volume")},
        .targets = {at("series")},
        .session = {}});
    addScene({.name = "history --deidentified",
        .words = {key("history"), session, key("--deidentified"), at("d.burin"), key("--force")},
        .targets = {at("d.burin")},
        .session = {}});
    addScene({.name = "history --report",
        .words = {key("history"), session, key("--report"), at("r.html"), key("--force")},
        .targets = {at("r.html")},
        .session = {}});
    addScene({.name = "mesh",
        .words = {key("mesh"), at("x.nii.gz"), key("--study"), m_study, key("--out"), at("m.stl"),
            key("--vertices"), key("200"), key("--force")},
        .targets = {at("m.stl")},
        .session = {}});
}

QString StormStage::at(const char* name) const
{
    return folder() + QLatin1Char('/') + QLatin1String(name);
}

QString StormStage::text(const char* name, const QJsonObject& content) const
{
    const QString path = m_home.path(QLatin1String(name));
    write(path, QJsonDocument(content).toJson());
    return path;
}

void StormStage::makeOld()
{
    QJsonArray exports;
    for (const auto& [format, name] : std::initializer_list<std::pair<const char*, const char*>>{
             {"nifti", "x.nii.gz"}, {"seg-nrrd", "x.seg.nrrd"}, {"obj", "x.obj"}, {"csv", "x.csv"},
             {"dicom-seg", "x.dcm"}, {"sr", "x-sr.dcm"}})
        exports.append(QJsonObject{{key("format"), key(format)}, {key("file"), at(name)}});
    const Outcome made = m_home.burin(
        {key("run"), text("old.json", {{key("edits"), edits(3)}, {key("export"), exports}}),
            key("--study"), m_study, key("--session"), at("a.burin")});
    if (made.status != 0)
        qFatal("old: %s", qPrintable(made.complaint));
    for (const char* name : {"x.ply", "r.html", "m.stl"})
        write(at(name), "old");
    QFile::copy(at("a.burin"), at("d.burin"));
    for (const QString& name : QDir(folder()).entryList(QDir::Files))
        m_old[QDir(folder()).filePath(name)] = read(QDir(folder()).filePath(name));
}

void StormStage::addScene(Scene scene)
{
    restore();
    QElapsedTimer clock;
    clock.start();
    const Outcome done = m_home.burin(scene.words);
    scene.milliseconds = int(clock.elapsed());
    if (done.status != 0)
        qFatal("%s: %s", scene.name, qPrintable(done.complaint));
    for (const QString& target : scene.targets)
        scene.made[target] = contentOf(target);
    const QStringList wrong = wrongs(scene, done, false);
    if (!wrong.isEmpty())
        qFatal("%s: %s", scene.name, qPrintable(wrong.join(QLatin1Char('\n'))));
    m_scenes.push_back(std::move(scene));
}

void StormStage::restore() const
{
    if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder()))
        qFatal("the folder cannot be emptied");
    for (auto file = m_old.begin(); file != m_old.end(); ++file) {
        write(file.key(), file.value());
        if (isSessionName(file.key()))
            QFile::setPermissions(file.key(), QFile::ReadOwner | QFile::WriteOwner);
    }
}

/// DICOM files hold new UIDs and the time: they are as large as the other one, and sound.
bool StormStage::isWholeExport(const Scene& scene, const QString& file) const
{
    constexpr qsizetype someLetters = 200;
    const QByteArray content = contentOf(file);
    const QByteArray made = scene.made[file];
    if (file.endsWith(QLatin1String(".dcm")))
        return core::soundObject(file) && std::abs(content.size() - made.size()) < someLetters;
    if (file.endsWith(QLatin1String(".html")))
        return content.trimmed().endsWith("</html>")
            && std::abs(content.size() - made.size()) < someLetters;
    return content == made;
}

QString StormStage::wrongOfSession(
    const QString& file, const QList<QJsonObject>& told, bool isWhole) const
{
    const QString name = QFileInfo(file).fileName() + QStringLiteral(": ");
    const core::Result<core::SessionContents> contents = core::checkSession(file);
    if (!contents)
        return name + contents.error().arguments.join(QLatin1Char(' '));
    if (!contents->isWhole() || (isWhole && !contents->leftOpen.isEmpty()))
        return name + QStringLiteral("it is not whole");
    for (const QJsonObject& line : told) {
        const core::RowId row = line[key("row")].toInteger(0);
        if (row < 1)
            continue;
        if (row > core::RowId(contents->rows.size()))
            return name + QStringLiteral("row %1 was told of and is not there").arg(row);
        if (QString::fromLatin1(contents->rows[std::size_t(row - 1)].stateHash)
            != line[key("hash")].toString())
            return name + QStringLiteral("row %1 is not what was told").arg(row);
    }
    return {};
}

QStringList StormStage::sessionsIn(const Scene& scene) const
{
    QStringList all;
    for (const QString& target : scene.targets) {
        if (isSessionName(target) && QFile::exists(target))
            all += target;
    }
    return all;
}

QStringList StormStage::wrongs(const Scene& scene, const Outcome& outcome, bool killed) const
{
    QStringList wrong;
    const bool done = outcome.status == 0 && !killed;
    QList<QJsonObject> told;
    std::copy_if(outcome.lines.begin(), outcome.lines.end(), std::back_inserter(told),
        [&scene](const QJsonObject& line) {
            return !scene.session.isEmpty() && line[key("row")].isDouble();
        });
    if (outcome.status < 0 && !killed)
        wrong += QStringLiteral("it crashed");
    bool toldIsKept = told.isEmpty();
    for (const QString& target : scene.targets) {
        const QString name = QFileInfo(target).fileName();
        const bool exists = QFileInfo::exists(target);
        // What was done last may lie beside the session itself.
        const bool isLeft = QFileInfo(target + QStringLiteral("-wal")).size() > 0
            || QFileInfo(target + QStringLiteral("-journal")).size() > 0;
        const bool isOld = exists
            ? !isLeft && m_old.contains(target) && read(target) == m_old[target]
            : !m_old.contains(target);
        if (done && isOld)
            wrong += name + QStringLiteral(" is as it was, and the command was content");
        if (isOld)
            continue;
        if (!exists) {
            wrong += name + QStringLiteral(" is gone");
        } else if (isSessionName(target)) {
            const QString flaw =
                wrongOfSession(target, target == scene.session ? told : QList<QJsonObject>(), done);
            // Killed before its first row it may not be one yet.
            if (!flaw.isEmpty() && !(killed && told.isEmpty() && !m_old.contains(target)))
                wrong += flaw;
            toldIsKept = toldIsKept || target == scene.session;
        } else if (!isWholeExport(scene, target)) {
            wrong += name + QStringLiteral(" is neither the old one nor the new one");
        }
    }
    for (const QString& name : QDir(folder()).entryList(
             QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot)) {
        const QString path = QDir(folder()).filePath(name);
        const bool isTarget = scene.targets.contains(path);
        if (m_old.contains(path) && !isTarget && read(path) != m_old[path])
            wrong += name + QStringLiteral(" was changed");
        if (m_old.contains(path) || isTarget)
            continue;
        bool isPart = false;
        for (const char* ending : {"-wal", "-shm", "-journal"})
            isPart = isPart
                || (name.endsWith(QLatin1String(ending)) && !name.startsWith(QLatin1Char('.')));
        QString owner = name;
        for (const char* ending : {"-wal", "-shm", "-journal"})
            owner.remove(QLatin1String(ending));
        const bool isNamed = outcome.complaint.contains(owner);
        if (isSessionName(name) && (isNamed || killed) && !told.isEmpty() && !toldIsKept)
            toldIsKept = wrongOfSession(path, told, false).isEmpty();
        if (done || !(isPart || isNamed || (killed && name.startsWith(QLatin1String(".burin-")))))
            wrong += name + QStringLiteral(" is left over");
    }
    for (auto file = m_old.begin(); file != m_old.end(); ++file) {
        if (!QFile::exists(file.key()) && !scene.targets.contains(file.key()))
            wrong += QFileInfo(file.key()).fileName() + QStringLiteral(" is gone");
    }
    if (!toldIsKept)
        wrong += QStringLiteral("what was told of is nowhere");
    return wrong;
}

QStringList StormStage::wrongsOfSessions(const Scene& scene) const
{
    QStringList wrong;
    for (const QString& session : sessionsIn(scene)) {
        if (scene.made[session].isEmpty() || session.endsWith(QLatin1String("d.burin")))
            continue;
        for (const QStringList& words :
            {QStringList{key("history"), session}, {key("replay"), session, key("--verify")}}) {
            const Outcome outcome = m_home.burin(words);
            if (outcome.status != 0)
                wrong += words.first() + QStringLiteral(": ") + outcome.complaint;
        }
    }
    return wrong;
}

} // namespace test

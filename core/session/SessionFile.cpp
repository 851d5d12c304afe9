// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionFile.h"

#include "core/base/TaskThread.h"
#include "core/edits/EditJson.h"
#include "core/session/SessionDatabase.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSqlQuery>

#include <mutex>
#include <optional>

namespace core {

namespace {

QString compact(const QJsonObject& object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

QVariant sqlId(RowId id)
{
    return qint64(id);
}

QJsonObject parsed(const QString& text)
{
    return QJsonDocument::fromJson(text.toUtf8()).object();
}

QString sha256(const QStringList& lines)
{
    const QByteArray message = lines.join(QLatin1Char('\n')).toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(message, QCryptographicHash::Sha256).toHex());
}

QString sha256(const BrickDelta& delta)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const QByteArray& piece : delta.pieces)
        hash.addData(piece);
    return QString::fromLatin1(hash.result().toHex());
}

QString toText(const EditStatistics& statistics)
{
    return compact({
        {QStringLiteral("voxelsChanged"), qint64(statistics.voxelsChanged)},
        {QStringLiteral("bricks"), statistics.bricks},
        {QStringLiteral("generations"), statistics.generations},
        {QStringLiteral("milliseconds"), statistics.milliseconds},
    });
}

EditStatistics statisticsFrom(const QString& text)
{
    const QJsonObject json = parsed(text);
    return {.voxelsChanged = json.value(QStringLiteral("voxelsChanged")).toInteger(),
        .bricks = json.value(QStringLiteral("bricks")).toInt(),
        .generations = json.value(QStringLiteral("generations")).toInt(),
        .milliseconds = json.value(QStringLiteral("milliseconds")).toDouble()};
}

/// A row as text, before and after the database.
struct RowText {
    RowId id = 0;
    RowId parent = 0;
    QString name;
    QString edit;
    QString statistics;
    qint64 growthGeneration = 0;

    [[nodiscard]] QString chain(const QString& previous) const
    {
        return sha256({previous, QString::number(id), QString::number(parent), name, edit,
            statistics, QString::number(growthGeneration)});
    }
};

QString seal(const QString& chain, const QString& stateHash, const QString& deltaSha256)
{
    return sha256({chain, stateHash, deltaSha256});
}

} // namespace

/// Everything here but the constructor and the queue belongs to the writer's thread.
class SessionFile::Writer {
public:
    explicit Writer(QString filePath)
        : path(std::move(filePath))
    {
    }
    ~Writer()
    {
        thread.run([this] { m_database.reset(); });
    }

    Result<void> create(const SessionSource& source)
    {
        Result<std::unique_ptr<SessionDatabase>> made = SessionDatabase::create(path);
        if (!made)
            return tl::unexpected(made.error());
        m_database = *std::move(made);
        const QString json = compact(source.toJson());
        contents.source = source;
        m_chains = {sha256({QStringLiteral("BurinSession1"), json})};
        write([&] {
            return m_database->run(QStringLiteral("INSERT INTO source VALUES (1, ?)"), {json});
        });
        return takeError();
    }

    Result<void> open(bool readOnly)
    {
        Result<std::unique_ptr<SessionDatabase>> opened = SessionDatabase::open(path, readOnly);
        if (!opened)
            return tl::unexpected(opened.error());
        m_database = *std::move(opened);
        if (const Result<void> read = readSource(); !read)
            return read;
        if (const Result<void> read = readRows(); !read)
            return read;
        return readState();
    }

    void addRow(const RowText& row)
    {
        const QString chain = row.chain(m_chains.back());
        const bool written = write([&] {
            return m_database->run(
                       QStringLiteral("INSERT INTO row (id, parent, name, edit, statistics,"
                                      " growthGeneration, chain) VALUES (?, ?, ?, ?, ?, ?, ?)"),
                       {sqlId(row.id), sqlId(row.parent), row.name, row.edit, row.statistics,
                           qint64(row.growthGeneration), chain})
                && writePosition(row.id);
        });
        if (written)
            m_chains.push_back(chain);
    }

    void completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta)
    {
        write([&] {
            for (std::size_t piece = 0; piece < delta.pieces.size(); ++piece) {
                if (!m_database->run(QStringLiteral("INSERT INTO delta VALUES (?, ?, ?)"),
                        {sqlId(row), int(piece), delta.pieces[piece]}))
                    return false;
            }
            const QString hash = QString::fromLatin1(stateHash);
            const QString deltaHash = sha256(delta);
            return m_database->run(
                QStringLiteral("UPDATE row SET stateHash=?, deltaSha256=?, seal=? WHERE id=?"),
                {hash, deltaHash, seal(m_chains[std::size_t(row)], hash, deltaHash), sqlId(row)});
        });
    }

    void setPosition(RowId position)
    {
        write([&] { return writePosition(position); });
    }

    void setState(const QString& key, const QString& value)
    {
        write([&] { return writeState(key, value); });
    }

    Result<BrickDelta> readDelta(RowId row)
    {
        BrickDelta delta;
        QString expected;
        const bool read =
            m_database->query(QStringLiteral("SELECT deltaSha256 FROM row WHERE id=?"),
                {sqlId(row)},
                [&expected](const QSqlQuery& answer) {
                    expected = answer.value(0).toString();
                    return true;
                })
            && m_database->query(
                QStringLiteral("SELECT bytes FROM delta WHERE row=? ORDER BY piece"), {sqlId(row)},
                [&delta](const QSqlQuery& answer) {
                    delta.pieces.push_back(answer.value(0).toByteArray());
                    return true;
                });
        if (!read)
            return damaged(row, m_database->reason());
        if (sha256(delta) != expected)
            return damaged(row, QStringLiteral("its difference was changed"));
        return delta;
    }

    Result<void> takeError()
    {
        if (!m_error)
            return {};
        return tl::unexpected(*m_error);
    }

    const QString path;
    SessionContents contents;
    TaskThread thread;

private:
    tl::unexpected<Error> damaged(RowId row, const QString& reason) const
    {
        return failure(ErrorCode::SessionDamaged, path,
            row == 0 ? reason : QStringLiteral("row %1: %2").arg(row).arg(reason));
    }

    /// After a failure nothing more is written: a row must not stand on one that is missing.
    bool write(const std::function<bool()>& work)
    {
        if (m_error)
            return false;
        if (m_database->transaction(work))
            return true;
        m_error = Error{ErrorCode::FileUnwritable, {path, m_database->reason()}};
        return false;
    }

    bool writePosition(RowId position)
    {
        return writeState(QStringLiteral("position"), QString::number(position))
            && m_database->run(
                QStringLiteral(
                    "INSERT OR REPLACE INTO visited SELECT parent, id FROM row WHERE id=?"),
                {sqlId(position)});
    }
    bool writeState(const QString& key, const QString& value)
    {
        return m_database->run(
            QStringLiteral("INSERT OR REPLACE INTO state VALUES (?, ?)"), {key, value});
    }

    Result<void> readSource()
    {
        QString json;
        const bool read = m_database->query(
            QStringLiteral("SELECT json FROM source"), {}, [&json](const QSqlQuery& answer) {
                json = answer.value(0).toString();
                return true;
            });
        const std::optional<SessionSource> source = SessionSource::fromJson(parsed(json));
        if (!read || !source)
            return damaged(0, QStringLiteral("it does not say what it was made on"));
        contents.source = *source;
        m_chains = {sha256({QStringLiteral("BurinSession1"), json})};
        return {};
    }

    Result<void> readRows()
    {
        Result<void> result;
        const bool read = m_database->query(
            QStringLiteral(
                "SELECT row.id, parent, name, edit, statistics, growthGeneration, chain,"
                " stateHash, deltaSha256, seal, SUM(LENGTH(bytes)) FROM row"
                " LEFT JOIN delta ON delta.row = row.id GROUP BY row.id ORDER BY row.id"),
            {}, [this, &result](const QSqlQuery& answer) {
                result = takeRow(answer);
                return bool(result);
            });
        if (!read)
            return damaged(0, m_database->reason());
        return result;
    }

    Result<void> takeRow(const QSqlQuery& answer)
    {
        const RowText text{.id = answer.value(0).toLongLong(),
            .parent = answer.value(1).toLongLong(),
            .name = answer.value(2).toString(),
            .edit = answer.value(3).toString(),
            .statistics = answer.value(4).toString(),
            .growthGeneration = answer.value(5).toLongLong()};
        const RowId expectedId = RowId(contents.rows.size()) + 1;
        if (text.id != expectedId || text.parent < 0 || text.parent >= text.id)
            return damaged(expectedId, QStringLiteral("it is missing or out of order"));
        const QString chain = text.chain(m_chains.back());
        if (chain != answer.value(6).toString())
            return damaged(text.id, QStringLiteral("it was changed after it was written"));
        m_chains.push_back(chain);

        HistoryRow row;
        row.id = text.id;
        row.parent = text.parent;
        row.name = text.name;
        row.statistics = statisticsFrom(text.statistics);
        row.growthGeneration = std::uint32_t(text.growthGeneration);
        Result<Edit> edit = editFromJson(parsed(text.edit));
        if (!edit)
            return damaged(text.id,
                QStringLiteral("its edit is not known here: ")
                    + edit.error().arguments.join(QStringLiteral(", ")));
        row.edit = *std::move(edit);
        if (!answer.value(9).isNull()) {
            const QString stateHash = answer.value(7).toString();
            if (answer.value(9).toString() != seal(chain, stateHash, answer.value(8).toString()))
                return damaged(
                    text.id, QStringLiteral("its hash was changed after it was written"));
            row.stateHash = stateHash.toLatin1();
            row.deltaBytes = std::size_t(answer.value(10).toLongLong());
        }
        contents.rows.push_back(std::move(row));
        return {};
    }

    Result<void> readState()
    {
        const auto isRow = [this](
                               RowId id) { return id >= 0 && id <= RowId(contents.rows.size()); };
        bool sound = true;
        const bool read = m_database->query(QStringLiteral("SELECT key, value FROM state"), {},
                              [&](const QSqlQuery& answer) {
                                  takeState(answer.value(0).toString(), answer.value(1).toString());
                                  return true;
                              })
            && m_database->query(QStringLiteral("SELECT parent, child FROM visited"), {},
                [&](const QSqlQuery& answer) {
                    const RowId parent = answer.value(0).toLongLong();
                    const RowId child = answer.value(1).toLongLong();
                    sound = sound && child > 0 && isRow(child)
                        && contents.rows[std::size_t(child - 1)].parent == parent;
                    contents.visited.emplace_back(parent, child);
                    return sound;
                });
        if (!read)
            return damaged(0, m_database->reason());
        if (!sound || !isRow(contents.position))
            return damaged(0, QStringLiteral("its position is no row"));
        return {};
    }

    void takeState(const QString& key, const QString& value)
    {
        if (key == QLatin1String("position"))
            contents.position = value.toLongLong();
        if (key == QLatin1String("hiddenSegments")) {
            const QJsonArray labels = QJsonDocument::fromJson(value.toUtf8()).array();
            for (const QJsonValue& label : labels)
                contents.hiddenSegments.push_back(label.toInt());
        }
    }

    std::unique_ptr<SessionDatabase> m_database;
    std::vector<QString> m_chains; ///< by row; [0] is the source's
    std::optional<Error> m_error;
};

SessionFile::SessionFile(std::unique_ptr<Writer> writer)
    : m_writer(std::move(writer))
{
}

SessionFile::~SessionFile() = default;

Result<std::unique_ptr<SessionFile>> SessionFile::create(
    const QString& path, const SessionSource& source, bool replaceExisting)
{
    const QFileInfo info(path);
    if (info.exists() && !replaceExisting)
        return failure(ErrorCode::FileExists, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnwritable, path, QStringLiteral("it is a folder"));
    if (!info.absoluteDir().exists())
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("there is no folder %1").arg(info.absolutePath()));
    for (const char* suffix : {"", "-wal", "-shm", "-journal"})
        QFile::remove(path + QLatin1String(suffix));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly,
            QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        return failure(ErrorCode::FileUnwritable, path, file.errorString());
    file.close();

    auto writer = std::make_unique<Writer>(path);
    Result<void> created;
    writer->thread.run([&] { created = writer->create(source); });
    if (!created) {
        writer.reset();
        QFile::remove(path);
        return tl::unexpected(created.error());
    }
    return std::unique_ptr<SessionFile>(new SessionFile(std::move(writer)));
}

Result<std::unique_ptr<SessionFile>> SessionFile::open(const QString& path, Access access)
{
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("it is a folder"));
    if (!info.isReadable())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("permission denied"));
    const bool readOnly = access == Access::ReadOnly;
    if (!readOnly && !(info.isWritable() && QFileInfo(info.absolutePath()).isWritable()))
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("a session is written while it is open; copy it to a folder of yours"));
    auto writer = std::make_unique<Writer>(path);
    Result<void> opened;
    writer->thread.run([&] { opened = writer->open(readOnly); });
    if (!opened)
        return tl::unexpected(opened.error());
    return std::unique_ptr<SessionFile>(new SessionFile(std::move(writer)));
}

const SessionContents& SessionFile::contents() const
{
    return m_writer->contents;
}

QString SessionFile::path() const
{
    return m_writer->path;
}

void SessionFile::addRow(const HistoryRow& row)
{
    RowText text{.id = row.id,
        .parent = row.parent,
        .name = row.name,
        .edit = compact(editToJson(row.edit)),
        .statistics = toText(row.statistics),
        .growthGeneration = row.growthGeneration};
    m_writer->thread.post(
        [writer = m_writer.get(), text = std::move(text)] { writer->addRow(text); });
}

void SessionFile::completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta)
{
    m_writer->thread.post([writer = m_writer.get(), row, stateHash, delta] {
        writer->completeRow(row, stateHash, delta);
    });
}

void SessionFile::setPosition(RowId position)
{
    m_writer->thread.post([writer = m_writer.get(), position] { writer->setPosition(position); });
}

void SessionFile::setHiddenSegments(const std::vector<int>& labels)
{
    QJsonArray list;
    for (const int label : labels)
        list.append(label);
    const QString text = QString::fromUtf8(QJsonDocument(list).toJson(QJsonDocument::Compact));
    m_writer->thread.post([writer = m_writer.get(), text] {
        writer->setState(QStringLiteral("hiddenSegments"), text);
    });
}

Result<BrickDelta> SessionFile::readDelta(RowId row)
{
    Result<BrickDelta> result;
    m_writer->thread.run([&] { result = m_writer->readDelta(row); });
    return result;
}

Result<void> SessionFile::flush()
{
    Result<void> result;
    m_writer->thread.run([&] { result = m_writer->takeError(); });
    return result;
}

} // namespace core

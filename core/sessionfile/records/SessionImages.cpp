// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionImages.h"

#include "core/dicom/source/KeptHeaders.h"
#include "core/sessionfile/database/SessionDatabase.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/ImagePieces.h"
#include "core/sessionfile/records/RowText.h"
#include "core/sessionfile/records/SessionSource.h"
#include "core/sessionfile/records/VolumeJson.h"
#include "core/study/FileFormats.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <QDataStream>
#include <QFile>
#include <QIODevice>
#include <QSqlQuery>

#include <algorithm>
#include <utility>

namespace core {

namespace {

constexpr qsizetype mostHeaderBytes = qsizetype(1) << 30;

/// The `source` row of a session that holds images.
struct ImageRow {
    SessionSource source;
    QString text; ///< JSON: the volume, and what its pieces are; empty: there are no images
    QString textSha256;
    QByteArray headers;
};

std::size_t pieceCount(const Volume& volume)
{
    return (volume.geometry.voxelCount() + voxelsPerPiece - 1) / voxelsPerPiece;
}

std::size_t sizeOfPiece(const Volume& volume, std::size_t piece)
{
    return std::min(voxelsPerPiece, volume.geometry.voxelCount() - piece * voxelsPerPiece);
}

/// Per header its name and its bytes, both as a length (4 bytes, little-endian) and what it counts.
QByteArray headersToBytes(const KeptHeaders& headers)
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setByteOrder(QDataStream::LittleEndian);
    for (const auto& [name, header] : headers)
        stream << name.toUtf8() << header;
    return bytes;
}

std::optional<KeptHeaders> headersFromBytes(const QByteArray& bytes)
{
    KeptHeaders headers;
    QDataStream stream(bytes);
    stream.setByteOrder(QDataStream::LittleEndian);
    while (!stream.atEnd()) {
        QByteArray name;
        QByteArray header;
        stream >> name >> header;
        if (stream.status() != QDataStream::Ok)
            return {};
        headers[QString::fromUtf8(name)] = header;
    }
    return headers;
}

Result<KeptHeaders> headersOf(const Volume& volume, const Progress& progress)
{
    if (volume.keptHeaders)
        return *volume.keptHeaders;
    if (volume.asIs)
        return keepHeaders(volume.asIs->sources, progress);
    if (!volume.sources.empty())
        return keepHeaders(volume.sources, progress);
    KeptHeaders headers;
    const FileFormat* format = fileFormatNamed(volume.sourceFormat);
    const QByteArray bytes = format ? format->headerBytes(volume.sourcePath) : QByteArray();
    if (!bytes.isEmpty())
        headers[volume.sourcePath] = bytes;
    return headers;
}

QJsonObject describe(const Volume& volume, const QByteArray& headers)
{
    return {
        {QStringLiteral("volume"), volumeToJson(volume)},
        {QStringLiteral("pieces"), qint64(pieceCount(volume))},
        {QStringLiteral("headersSha256"), sha256(headers)},
    };
}

bool writeRow(SessionDatabase& database, const ImageRow& row)
{
    return database.run(
        QStringLiteral("UPDATE source SET images=?, imagesSha256=?, headers=? WHERE id=1"),
        {row.text, row.textSha256, row.headers});
}

bool writePiece(SessionDatabase& database, std::size_t piece, const QByteArray& bytes)
{
    return database.run(
        QStringLiteral("INSERT INTO pixels (piece, sha256, bytes) VALUES (?, ?, ?)"),
        {qint64(piece), sha256(bytes), bytes});
}

Result<void> writeImages(const QString& path, const LoadedVolume& study, const Progress& progress)
{
    const Volume& volume = study.volume;
    const Result<KeptHeaders> headers = headersOf(volume, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    // The source is written last: without it the file is no session, whatever pieces are there.
    const Result<std::unique_ptr<SessionDatabase>> made =
        SessionDatabase::create(path, [](SessionDatabase&) { return true; });
    if (!made)
        return tl::unexpected(made.error());
    SessionDatabase& database = **made;
    const auto unwritable = [&] {
        return failure(ErrorCode::FileUnwritable, path, database.reason());
    };
    const std::size_t pieces = pieceCount(volume);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::WritingImages, int(piece), int(pieces));
        const QByteArray bytes =
            packedPiece({study.codes.data() + piece * voxelsPerPiece, sizeOfPiece(volume, piece)});
        if (!database.transaction([&] { return writePiece(database, piece, bytes); }))
            return unwritable();
    }
    ImageRow row;
    row.headers = packed(headersToBytes(*headers));
    row.text = compact(describe(volume, row.headers));
    row.textSha256 = sha256(row.text.toUtf8());
    const QString source = compact(SessionSource::of(volume).toJson());
    const bool described = database.transaction([&] {
        return database.run(QStringLiteral("INSERT INTO source (id, json) VALUES (1, ?)"), {source})
            && writeRow(database, row);
    });
    if (!described)
        return unwritable();
    return {};
}

tl::unexpected<Error> damaged(const QString& path, const Clause& reason)
{
    return failure(ErrorCode::SessionDamaged, path, reason);
}

Result<ImageRow> readRow(SessionDatabase& database, const QString& path)
{
    ImageRow row;
    const bool readable =
        database.query(QStringLiteral("SELECT json, images, imagesSha256, headers FROM source"), {},
            [&row](const QSqlQuery& answer) {
                const auto source = SessionSource::fromJson(parsed(answer.value(0).toString()));
                row = {.source = source.value_or(SessionSource{}),
                    .text = answer.value(1).toString(),
                    .textSha256 = answer.value(2).toString(),
                    .headers = answer.value(3).toByteArray()};
                return true;
            });
    if (!readable)
        return damaged(path, database.reason());
    if (row.text.isEmpty())
        return failure(
            ErrorCode::NoImages, path, Clause::saying("the session was saved without them"));
    if (sha256(row.text.toUtf8()) != row.textSha256)
        return damaged(path, Clause::saying("what describes its images was changed"));
    return row;
}

Result<QByteArray> readPiece(
    SessionDatabase& database, const QString& path, std::size_t piece, std::size_t pieces)
{
    QString expected;
    QByteArray bytes;
    const bool read =
        database.query(QStringLiteral("SELECT sha256, bytes FROM pixels WHERE piece=?"),
            {qint64(piece)}, [&](const QSqlQuery& answer) {
                expected = answer.value(0).toString();
                bytes = answer.value(1).toByteArray();
                return true;
            });
    const Clause which = Clause::saying("piece %1 of %2 of its images", piece + 1, pieces);
    if (!read)
        return damaged(path, Clause::saying("%1 cannot be read: %2", which, database.reason()));
    if (expected.isEmpty())
        return damaged(path, Clause::saying("%1 is missing", which));
    if (sha256(bytes) != expected)
        return damaged(path, Clause::saying("%1 was changed after it was written", which));
    return bytes;
}

/// The volume that a row describes, without voxels.
Result<Volume> volumeOf(const ImageRow& row, const QString& path)
{
    const QJsonObject json = parsed(row.text);
    std::optional<Volume> volume = volumeFromJson(json[QStringLiteral("volume")].toObject());
    if (!volume || json[QStringLiteral("pieces")].toInteger() != qint64(pieceCount(*volume)))
        return damaged(path, Clause::saying("what describes its images makes no sense"));
    if (const Clause difference = row.source.differenceFrom(*volume); !difference.isEmpty())
        return damaged(
            path, Clause::saying("the images it holds are of another study: %1", difference));
    const std::optional<QByteArray> bytes = unpacked(row.headers, mostHeaderBytes);
    std::optional<KeptHeaders> headers =
        bytes && sha256(row.headers) == json[QStringLiteral("headersSha256")].toString()
        ? headersFromBytes(*bytes)
        : std::nullopt;
    if (!headers)
        return damaged(path, Clause::saying("the headers of its images were changed"));
    volume->keptHeaders = std::make_shared<const KeptHeaders>(*std::move(headers));
    return *std::move(volume);
}

/// Whether the voxels are those that the session was made on.
bool agrees(const LoadedVolume& loaded, const SessionSource& source)
{
    const Volume& volume = loaded.volume;
    if (volume.codesSha256.isEmpty())
        return sha256OfValues(loaded) == volume.voxelsSha256;
    const QByteArray& expected =
        source.codesSha256.isEmpty() ? volume.codesSha256 : source.codesSha256;
    return sha256OfCodes(loaded) == expected;
}

Error renamed(Error error, const QString& from, const QString& to)
{
    error.arguments.exchange(from, to);
    return error;
}

} // namespace

Result<StagedFile> stageImages(const QString& target, bool replaceExisting,
    const LoadedVolume& study, const Progress& progress)
{
    Result<StagedFile> staged = StagedFile::create(target, replaceExisting, true);
    if (!staged)
        return staged;
    const QString path = staged->path();
    QFile::setPermissions(path, QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    if (const Result<void> written = writeImages(path, study, progress); !written) {
        removeSession(path);
        return tl::unexpected(renamed(written.error(), path, target));
    }
    return staged;
}

Result<LoadedVolume> loadSessionImages(const QString& sessionFile, const Progress& progress)
{
    const Result<std::unique_ptr<SessionDatabase>> database =
        SessionDatabase::open(sessionFile, true);
    if (!database)
        return tl::unexpected(database.error());
    const Result<ImageRow> row = readRow(**database, sessionFile);
    if (!row)
        return tl::unexpected(row.error());
    Result<Volume> volume = volumeOf(*row, sessionFile);
    if (!volume)
        return tl::unexpected(volume.error());
    if (const Result<void> fits = checkMemory(volume->geometry.voxelCount()); !fits)
        return tl::unexpected(fits.error());
    LoadedVolume loaded;
    loaded.volume = *std::move(volume);
    loaded.codes.resize(loaded.volume.geometry.voxelCount());
    const std::size_t pieces = pieceCount(loaded.volume);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(ProgressStep::ReadingImages, int(piece), int(pieces));
        const Result<QByteArray> bytes = readPiece(**database, sessionFile, piece, pieces);
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (!unpackPiece(*bytes,
                {loaded.codes.data() + piece * voxelsPerPiece, sizeOfPiece(loaded.volume, piece)}))
            return damaged(sessionFile,
                Clause::saying("piece %1 of %2 of its images is no piece", piece + 1, pieces));
    }
    if (!agrees(loaded, row->source))
        return damaged(
            sessionFile, Clause::saying("the images it holds are not those that it was made on"));
    return loaded;
}

Result<void> copySessionImages(const QString& from, const QString& to)
{
    const Result<std::unique_ptr<SessionDatabase>> source = SessionDatabase::open(from, true);
    if (!source)
        return tl::unexpected(source.error());
    const Result<ImageRow> row = readRow(**source, from);
    if (!row)
        return tl::unexpected(row.error());
    const Result<Volume> volume = volumeOf(*row, from);
    if (!volume)
        return tl::unexpected(volume.error());
    const Result<std::unique_ptr<SessionDatabase>> target = SessionDatabase::open(to, false);
    if (!target)
        return tl::unexpected(target.error());
    const std::size_t pieces = pieceCount(*volume);
    std::optional<Error> lost;
    const bool copied = (*target)->transaction([&] {
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            const Result<QByteArray> bytes = readPiece(**source, from, piece, pieces);
            if (!bytes)
                lost = bytes.error();
            if (!bytes || !writePiece(**target, piece, *bytes))
                return false;
        }
        return writeRow(**target, *row);
    });
    if (lost)
        return tl::unexpected(*lost);
    if (!copied)
        return failure(ErrorCode::FileUnwritable, to, (*target)->reason());
    return {};
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/ObjectIntake.h"

#include "core/pacs/Association.h"

#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dimse.h>

#include <cstring>

namespace core {

namespace {

/// Of file meta information, in Explicit VR Little Endian (PS3.10 7.1).
void append(QByteArray& meta, std::uint16_t element, const char* vr, QByteArray value)
{
    const bool isUid = std::strcmp(vr, "UI") == 0;
    if (value.size() % 2 != 0)
        value.append(isUid ? '\0' : ' ');
    const auto word = [&meta](unsigned number) {
        meta.append(char(number & 0xffU));
        meta.append(char((number >> 8) & 0xffU));
    };
    word(2);
    word(element);
    meta.append(vr, 2);
    if (std::strcmp(vr, "OB") == 0) {
        word(0);
        word(unsigned(value.size()));
        word(0);
    } else {
        word(unsigned(value.size()));
    }
    meta.append(value);
}

QByteArray metaInformation(const T_DIMSE_C_StoreRQ& request, const QByteArray& transferSyntax)
{
    QByteArray rest;
    append(rest, 0x0001, "OB", QByteArray("\0\1", 2));
    append(rest, 0x0002, "UI", request.AffectedSOPClassUID);
    append(rest, 0x0003, "UI", request.AffectedSOPInstanceUID);
    append(rest, 0x0010, "UI", transferSyntax);
    append(rest, 0x0012, "UI", "2.25.115094834019420271389270316438251847306");
    append(rest, 0x0013, "SH", "BURIN");
    QByteArray size(4, '\0');
    for (int i = 0; i < 4; ++i)
        size[i] = char((rest.size() >> (8 * i)) & 0xff);
    QByteArray meta(128, '\0');
    meta.append("DICM");
    append(meta, 0x0000, "UL", size);
    return meta + rest;
}

/// A file on its way; gone with this unless it got its name.
struct Part {
    QString path;
    ~Part() { QFile::remove(path); }
};

/// @return what the system says against it, empty if nothing; a disk that fills up takes a part
/// first
QString writeAll(QFile& file, const char* bytes, qint64 size)
{
    while (size > 0) {
        const qint64 count = file.write(bytes, size);
        if (count <= 0)
            return file.errorString();
        bytes += count;
        size -= count;
    }
    return {};
}

} // namespace

ObjectIntake::ObjectIntake(const DownloadFolder& folder, const QSet<QString>& awaited,
    bool takesAll, const Progress& progress)
    : m_folder(folder)
    , m_takesAll(takesAll)
    , m_missing(awaited)
    , m_total(takesAll ? 0 : int(awaited.size()))
    , m_progress(progress)
{
}

Result<void> ObjectIntake::take(
    Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request)
{
    const Result<std::uint16_t> status = write(association, context, request);
    if (!status && status.error().code != ErrorCode::FileUnwritable)
        return tl::unexpected<Error>(status.error());
    T_DIMSE_C_StoreRSP response{};
    response.DimseStatus = status.value_or(STATUS_STORE_Refused_OutOfResources);
    const OFCondition answered =
        DIMSE_sendStoreResponse(association.get(), context, &request, &response, nullptr);
    if (!status)
        return tl::unexpected<Error>(status.error());
    if (answered.bad())
        return tl::unexpected<Error>(association.error(answered));
    association.notePassed();
    return {};
}

Result<std::uint16_t> ObjectIntake::write(
    Association& association, std::uint8_t context, const T_DIMSE_C_StoreRQ& request)
{
    const QString uid = QString::fromLatin1(request.AffectedSOPInstanceUID);
    if (!m_takesAll && !m_missing.contains(uid)) {
        const Result<void> ignored =
            association.receiveData(context, [](const char*, std::size_t) {});
        if (!ignored)
            return tl::unexpected<Error>(ignored.error());
        return STATUS_STORE_Refused_NotAuthorized;
    }
    const QByteArray meta = metaInformation(request, association.transferSyntax(context));
    QString trouble;
    const Part part{m_folder.partPathOf(uid)};
    QFile file(part.path);
    if (file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        trouble = writeAll(file, meta.constData(), meta.size());
    else
        trouble = file.errorString();
    const Result<void> received =
        association.receiveData(context, [&](const char* bytes, std::size_t size) {
            ++m_pieces;
            if (m_onPiece)
                m_onPiece();
            // A disk that is full now may take the next bytes: a file with a hole.
            if (trouble.isEmpty())
                trouble = writeAll(file, bytes, qint64(size));
        });
    if (!received)
        return tl::unexpected<Error>(received.error());
    file.close();
    if (!trouble.isEmpty())
        return failure(ErrorCode::FileUnwritable, m_folder.target(), trouble);
    if (const Result<void> sound = checkObject(part.path, uid); !sound) {
        if (!m_refusal)
            m_refusal = sound.error();
        return STATUS_STORE_Error_CannotUnderstand;
    }
    if (const Result<void> accepted = m_folder.accept(part.path, uid); !accepted)
        return tl::unexpected<Error>(accepted.error());
    m_missing.remove(uid);
    ++m_received;
    m_progress.report(ProgressStep::Downloading, m_received, m_total);
    return STATUS_STORE_Success;
}

} // namespace core

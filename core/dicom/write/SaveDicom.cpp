// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SaveDicom.h"

#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrma.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

/// Takes what DCMTK writes; after a failure nothing more.
class FileConsumer final : public DcmConsumer {
public:
    explicit FileConsumer(QFile& file)
        : m_file(file)
    {
    }
    OFBool good() const override { return m_good; }
    OFCondition status() const override { return m_good ? EC_Normal : EC_InvalidStream; }
    OFBool isFlushed() const override { return OFTrue; }
    offile_off_t avail() const override { return 1 << 30; }
    offile_off_t write(const void* bytes, offile_off_t size) override
    {
        m_good = m_good && m_file.write(static_cast<const char*>(bytes), size) == size;
        return m_good ? size : 0;
    }
    void flush() override { }

private:
    QFile& m_file;
    bool m_good = true;
};

class FileStream final : public DcmOutputStream {
public:
    explicit FileStream(FileConsumer& consumer)
        : DcmOutputStream(&consumer)
    {
    }
};

} // namespace

Result<void> saveDicom(DcmFileFormat& format, const QString& path, const char* transferSyntaxUid)
{
    QFile file(path);
    const auto refused = [&] {
        return failure(ErrorCode::FileUnwritable, path, file.errorString());
    };
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate))
        return refused();
    OFCondition written;
    {
        FileConsumer consumer(file);
        FileStream stream(consumer);
        format.transferInit();
        written = format.write(stream, DcmXfer(transferSyntaxUid).getXfer(), EET_UndefinedLength,
            nullptr, EGL_recalcGL, EPD_noChange);
        format.transferEnd();
        stream.flush();
    }
    if (file.error() != QFileDevice::NoError || !file.flush())
        return refused();
    if (written.bad())
        return failure(ErrorCode::FileUnwritable, path, QString::fromLatin1(written.text()));
    return {};
}

} // namespace core

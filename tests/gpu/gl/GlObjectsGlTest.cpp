// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Fence.h"
#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/GpuTrace.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"
#include "gpu/gl/VertexArray.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/program/TraceEvents.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace glObjectsGlTest {

using namespace gpu;

class GlObjectsGlTest : public test::GlTest {
    Q_OBJECT

    QTemporaryDir m_folder;

    void write(const char* name, const QByteArray& text)
    {
        QFile file(m_folder.filePath(QString::fromLatin1(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    [[nodiscard]] ShaderLibrary library() const { return ShaderLibrary(m_folder.path()); }

private Q_SLOTS:
    void idsMoveAndDelete()
    {
        GLuint id = 0;
        {
            Buffer first({.label = "first", .bytes = 16});
            id = first.id();
            Buffer second = std::move(first);
            QVERIFY(!first); // NOLINT: moved-from is none
            QCOMPARE(second.id(), id);
            QVERIFY(glIsBuffer(id));
        }
        QVERIFY(!glIsBuffer(id));
    }

    void buffersKeepWhatIsWritten()
    {
        Buffer buffer({.label = "words", .bytes = 64});
        buffer.fill(0xFFFFFFFFu);
        const std::array<std::uint32_t, 2> words{7, 9};
        buffer.write<std::uint32_t>(words, 8);
        std::array<std::uint32_t, 4> back{};
        buffer.read<std::uint32_t>(back, 4);
        QCOMPARE(back, (std::array<std::uint32_t, 4>{0xFFFFFFFFu, 7, 9, 0xFFFFFFFFu}));

        Buffer mapped({.label = "mapped", .bytes = 64, .use = BufferUse::MappedRead});
        buffer.copyTo(mapped, 64);
        Fence::insert().wait();
        std::memcpy(back.data(), mapped.mapped() + 4, 16);
        QCOMPARE(back, (std::array<std::uint32_t, 4>{0xFFFFFFFFu, 7, 9, 0xFFFFFFFFu}));
    }

    void texturesUploadClearAndReadBoxes_data()
    {
        QTest::addColumn<unsigned>("format");
        QTest::newRow("R8") << unsigned(GL_R8);
        QTest::newRow("R8UI") << unsigned(GL_R8UI);
        QTest::newRow("R16") << unsigned(GL_R16);
        QTest::newRow("R16UI") << unsigned(GL_R16UI);
        QTest::newRow("R32UI") << unsigned(GL_R32UI);
        QTest::newRow("RG16") << unsigned(GL_RG16);
    }

    void texturesUploadClearAndReadBoxes()
    {
        QFETCH(unsigned, format);
        // An odd width: rows must not be padded.
        Texture3D texture({.label = "box", .size = {5, 4, 3}, .format = format});
        texture.clear();
        const std::size_t texel = texelLayout(format).bytes;
        std::vector<std::uint8_t> box(3 * 2 * 2 * texel);
        std::iota(box.begin(), box.end(), std::uint8_t(1));
        texture.upload({1, 1, 1}, {3, 2, 2}, std::as_bytes(std::span(box)));
        std::vector<std::uint8_t> back(box.size());
        texture.read({1, 1, 1}, {3, 2, 2}, std::as_writable_bytes(std::span(back)));
        QCOMPARE(back, box);
        std::vector<std::uint8_t> outside(5 * texel, 0xAA);
        texture.read({0, 0, 1}, {5, 1, 1}, std::as_writable_bytes(std::span(outside)));
        QCOMPARE(outside, std::vector<std::uint8_t>(5 * texel, 0));
        texture.clear({1, 1, 1}, {1, 1, 1});
        texture.read({1, 1, 1}, {3, 2, 2}, std::as_writable_bytes(std::span(back)));
        std::fill_n(box.begin(), texel, std::uint8_t(0));
        QCOMPARE(back, box);
    }

    void viewsReadOneStorageAsIntegers()
    {
        write("view.comp",
            "layout(local_size_x = 1) in;\n"
            "layout(binding = 0) uniform sampler3D asFloat;\n"
            "layout(binding = 1) uniform usampler3D asInteger;\n"
            "layout(std430, binding = 0) buffer Result { uint integer; uint rounded; };\n"
            "void main() {\n"
            "  integer = texelFetch(asInteger, ivec3(1, 0, 0), 0).r;\n"
            "  rounded = uint(texture(asFloat, vec3(0.75, 0.5, 0.5)).r * 65535.0 + 0.5);\n"
            "}\n");
        Texture3D intensity(
            {.label = "codes", .size = {2, 1, 1}, .format = GL_R16, .linear = true});
        intensity.upload<std::uint16_t>(std::array<std::uint16_t, 2>{17, 54321});
        const Texture3D integers = intensity.view(GL_R16UI, "codes as integers");
        const Program program(library(), {.label = "view", .path = "view.comp"});
        Buffer result({.label = "result", .bytes = 8});
        intensity.bindUnit(0);
        integers.bindUnit(1);
        result.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        program.dispatch({1, 1, 1});
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::array<std::uint32_t, 2> read{};
        result.read<std::uint32_t>(read);
        QCOMPARE(read[0], 54321u);
        QCOMPARE(read[1], 54321u);
    }

    void kernelsRunDirectlyAndIndirectly()
    {
        write("count.comp",
            "layout(local_size_x = STEP) in;\n"
            "layout(std430, binding = 0) buffer Total { uint total; };\n"
            "uniform uvec4 weights[2];\n"
            "uniform int offset;\n"
            "void main() { atomicAdd(total, weights[1].z + uint(offset)); }\n");
        Program program(
            library(), {.label = "count", .path = "count.comp", .defines = {{"STEP", 4}}});
        program.set("offset", 2).set("unknown", 5);
        QVERIFY(program.hasUniform("weights"));
        QVERIFY(!program.hasUniform("unknown"));
        const std::array<GLuint, 8> weights{0, 0, 0, 0, 0, 0, 3, 0};
        glProgramUniform4uiv(
            program.id(), glGetUniformLocation(program.id(), "weights"), 2, weights.data());
        Buffer total({.label = "total", .bytes = 4});
        total.fill(0);
        total.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        program.dispatch({2, 1, 1});
        Buffer groups({.label = "groups", .bytes = 16});
        groups.write<GLuint>(std::array<GLuint, 4>{0, 3, 1, 1});
        program.dispatchIndirect(groups, 4);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::array<GLuint, 1> sum{};
        total.read<GLuint>(sum);
        QCOMPARE(sum[0], (2u + 3u) * 4u * 5u);
    }

    void trianglesCoverTheFrame()
    {
        write("where.frag",
            "uniform vec2 scale;\n"
            "layout(location = 0) out vec4 colour;\n"
            "void main() { colour = vec4(gl_FragCoord.xy * scale / 255.0, 0.0, 1.0); }\n");
        QFile::copy(QStringLiteral(BURIN_SOURCE_DIR "/gpu/shaders/fullScreen.vert"),
            m_folder.filePath(QStringLiteral("fullScreen.vert")));
        Program program(library(),
            {.label = "where", .vertexPath = "fullScreen.vert", .fragmentPath = "where.frag"});
        program.set("scale", glm::vec2(2.0f, 2.0f));
        const Texture2D target({.label = "target", .size = {7, 5}});
        const Framebuffer framebuffer({.label = "frame", .colours = {&target}});
        const VertexArray nothing("nothing");
        framebuffer.bind();
        program.use();
        nothing.drawFullScreenTriangle();
        const Buffer pixels({.label = "pixels", .bytes = 7 * 5 * 4, .use = BufferUse::MappedRead});
        framebuffer.readInto(pixels.id());
        Fence::insert().wait();
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels.mapped());
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 7; ++x) {
                QCOMPARE(int(bytes[(y * 7 + x) * 4]), 2 * x + 1);
                QCOMPARE(int(bytes[(y * 7 + x) * 4 + 1]), 2 * y + 1);
            }
        }
    }

    /// Kernels and draws one after the other, each by its name, with the time that it took.
    void whatRunsIsTraced()
    {
        GLint bits = 0;
        glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
        if (bits == 0)
            QSKIP("this driver has no timestamps");
        write("long.comp",
            "layout(local_size_x = 64) in;\n"
            "layout(std430, binding = 0) buffer Sums { uint sums[]; };\n"
            "void main() {\n"
            "    uint sum = gl_GlobalInvocationID.x;\n"
            "    for (uint i = 0u; i < 2000u; ++i) sum = sum * 1664525u + i;\n"
            "    sums[gl_GlobalInvocationID.x] = sum;\n"
            "}\n");
        write("plain.frag",
            "layout(location = 0) out vec4 colour;\n"
            "void main() { colour = vec4(gl_FragCoord.x); }\n");
        QFile::copy(QStringLiteral(BURIN_SOURCE_DIR "/gpu/shaders/fullScreen.vert"),
            m_folder.filePath(QStringLiteral("fullScreen.vert")));
        const Program kernel(library(), {.label = "a kernel", .path = "long.comp"});
        const Program pass(library(),
            {.label = "a pass", .vertexPath = "fullScreen.vert", .fragmentPath = "plain.frag"});
        const Buffer sums({.label = "sums", .bytes = 64 * 16 * 4});
        sums.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        const Texture2D target({.label = "target", .size = {256, 256}});
        const Framebuffer framebuffer({.label = "frame", .colours = {&target}});
        framebuffer.bind();
        const VertexArray nothing("nothing");
        constexpr int rounds = 3;
        const auto run = [&] {
            for (int i = 0; i < rounds; ++i) {
                kernel.dispatch({16, 1, 1});
                pass.use();
                nothing.drawFullScreenTriangle();
            }
        };
        run(); // drivers compile at first use
        core::Trace::begin();
        {
            const GpuTrace trace;
            run();
        }
        run(); // of which nothing is measured any more
        const std::vector<test::TraceEvent> events =
            test::traceEvents(QByteArray::fromStdString(core::Trace::end()));
        QCOMPARE(events.size(), std::size_t(2 * rounds));
        QVERIFY2(test::overlapIn(events).isEmpty(), qPrintable(test::overlapIn(events)));
        int kernels = 0;
        for (const test::TraceEvent& event : events) {
            QCOMPARE(event.category, QStringLiteral("gpu"));
            QVERIFY(event.lane.contains(QLatin1String(" GPU: ")));
            if (event.name == QLatin1String("a kernel"))
                ++kernels;
            else
                QCOMPARE(event.name, QStringLiteral("a pass"));
        }
        QCOMPARE(kernels, rounds);
        QVERIFY(test::timeIn(events, "gpu", "a kernel") > 0);
        QVERIFY(test::timeIn(events, "gpu", "a pass") > 0);
    }

    void compileErrorsNameFileAndLine()
    {
        write("helper.glsl", "\n\nfloat broken( { }\n");
        write("broken.comp",
            "layout(local_size_x = 1) in;\n#include \"helper.glsl\"\nvoid main() {}\n");
        QString message;
        try {
            const Program program(library(), {.label = "broken", .path = "broken.comp"});
        } catch (const ShaderError& error) {
            message = QString::fromUtf8(error.what());
        }
        QVERIFY2(message.contains(QStringLiteral("helper.glsl:3")), qPrintable(message));
        (void)newErrors();
    }

    void errorsAreCounted()
    {
        QTest::ignoreMessage(QtCriticalMsg, QRegularExpression(QStringLiteral("GL error")));
        glBindTextureUnit(0, 987654);
        QCOMPARE(newErrors(), 1);
    }
};

BURIN_TEST(GlObjectsGlTest)

} // namespace glObjectsGlTest

#include "GlObjectsGlTest.moc"

// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A texture image of the host's, read in place and only during the call: either pixels or the bytes of a file.</summary>
    public sealed unsafe class Image : Record
    {
        /// <summary>UTF-8 file name without a folder; may be left out</summary>
        public string Name { get; set; }
        /// <summary>height rows of width x 3 red green blue, from the top; may be left out</summary>
        public byte[] Pixels { get; set; }
        /// <summary>from row to row; 0: tightly packed</summary>
        public ulong RowStrideBytes { get; set; }
        /// <summary>of pixels, else 0</summary>
        public uint Width { get; set; }
        /// <summary>of pixels, else 0</summary>
        public uint Height { get; set; }
        /// <summary>the bytes of a JPEG or PNG file; may be left out: when pixels are given</summary>
        public byte[] File { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Image*)at;
            raw->rowStrideBytes = RowStrideBytes;
            raw->width = Width;
            raw->height = Height;
            raw->name = call.TextOrNull(Name);
            raw->pixels = call.Array(Pixels);
            if (Pixels != null) call.Agree("pixels", call.Rows(Pixels, (long)raw->width * 3, "pixels"), (long)raw->height);
            raw->file = call.Array(File);
            raw->fileSize = (ulong)call.Rows(File, 1, "file");
        }
    }
}

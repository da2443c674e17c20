// Checks a machine, prints its findings as JSON, and writes its image, for .NET and Mono:
//   CheckAndCompile.exe INPUT IMAGE.axim
// Exit status: 0, 1 for lists with errors, 2 where there is nothing to check.
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

/// A workspace of axisc.h. Texts are UTF-8 there, and end with a NUL.
sealed class Workspace : IDisposable {
  IntPtr handle;

  public Workspace(string options) { Require(axisc_open(Text(options), IntPtr.Zero, out handle)); }

  public void Dispose() {
    axisc_close(handle);
    handle = IntPtr.Zero;
  }

  /// Whether the lists are without errors; `findings` is a JSON object.
  public bool Check(string path, out string findings) {
    Bytes bytes;
    int result = axisc_check(handle, Text(path), out bytes);
    findings = Encoding.UTF8.GetString(Taken(ref bytes));
    Require(result);
    return result == 0;
  }

  /// Null where lists have errors.
  public byte[] Compile(string path) {
    Bytes bytes;
    int result = axisc_compile(handle, Text(path), null, out bytes, IntPtr.Zero);
    byte[] image = Taken(ref bytes);
    Require(result);
    return result == 0 ? image : null;
  }

  /// Results below 0 say that there is none.
  void Require(int result) {
    if (result >= 0) return;
    IntPtr words = axisc_error(handle);
    int length = 0;
    while (Marshal.ReadByte(words, length) != 0) ++length;
    byte[] error = new byte[length];
    Marshal.Copy(words, error, 0, length);
    throw new InvalidOperationException(Encoding.UTF8.GetString(error).TrimEnd());
  }

  static byte[] Text(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }

  static byte[] Taken(ref Bytes bytes) {
    byte[] copy = new byte[checked((int)bytes.Size.ToUInt64())];
    if (copy.Length > 0) Marshal.Copy(bytes.Data, copy, 0, copy.Length);
    axisc_free(ref bytes);
    return copy;
  }

  [StructLayout(LayoutKind.Sequential)]
  struct Bytes {
    public IntPtr Data;
    public UIntPtr Size;
  }

  const string Library = "libaxisc.so.0";  // the number is AXISC_ABI_VERSION
  const CallingConvention C = CallingConvention.Cdecl;
  [DllImport(Library, CallingConvention = C)] static extern int axisc_open(byte[] options, IntPtr files, out IntPtr workspace);
  [DllImport(Library, CallingConvention = C)] static extern void axisc_close(IntPtr workspace);
  [DllImport(Library, CallingConvention = C)] static extern int axisc_check(IntPtr workspace, byte[] path, out Bytes findings);
  [DllImport(Library, CallingConvention = C)] static extern int axisc_compile(IntPtr workspace, byte[] path, byte[] options, out Bytes image, IntPtr findings);
  [DllImport(Library, CallingConvention = C)] static extern IntPtr axisc_error(IntPtr workspace);
  [DllImport(Library, CallingConvention = C)] static extern void axisc_free(ref Bytes bytes);
}

static class CheckAndCompile {
  static int Main(string[] arguments) {
    if (arguments.Length != 2) {
      Console.Error.WriteLine("usage: CheckAndCompile.exe INPUT IMAGE.axim");
      return 2;
    }
    try {
      using (var workspace = new Workspace("{\"language\": \"en\", \"cycle_time\": \"1ms\"}")) {
        string findings;
        bool sound = workspace.Check(arguments[0], out findings);
        Console.Write(findings);
        byte[] image = sound ? workspace.Compile(arguments[0]) : null;
        if (image == null) return 1;
        File.WriteAllBytes(arguments[1], image);
        return 0;
      }
    } catch (Exception error) {
      Console.Error.WriteLine(error.Message);
      return 2;
    }
  }
}

// As much of Unity as the exported importer calls, and a program that shows what it imports.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public enum FilterMode { Point, Bilinear, Trilinear }
    public enum TextureWrapMode { Repeat, Clamp }
    public class Object { }
    public class Texture : Object
    {
        public FilterMode filterMode;
        public int anisoLevel;
        public TextureWrapMode wrapMode;
        public readonly List<string> Said = new List<string>();
        protected void Say(string what, byte[] data)
        {
            uint sum = 0;
            foreach (byte b in data) sum = sum * 31 + b;
            Said.Add(what + " " + data.Length + " " + sum);
        }
    }
    public class Texture2D : Texture
    {
        public Texture2D(int width, int height, Experimental.Rendering.GraphicsFormat format, int mipCount,
            Experimental.Rendering.TextureCreationFlags flags)
        {
            Said.Add("2D " + width + " " + height + " 1 " + format + " " + mipCount);
        }
        public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0)
        {
            Say("0 " + mipLevel, (byte[])(object)data);
        }
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { }
    }
    public class Texture2DArray : Texture
    {
        public Texture2DArray(int width, int height, int depth, Experimental.Rendering.GraphicsFormat format,
            Experimental.Rendering.TextureCreationFlags flags, int mipCount)
        {
            Said.Add("2DArray " + width + " " + height + " " + depth + " " + format + " " + mipCount);
        }
        public void SetPixelData<T>(T[] data, int mipLevel, int element, int sourceDataStartIndex = 0)
        {
            Say(element + " " + mipLevel, (byte[])(object)data);
        }
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { }
    }
    public class Shader : Object { public static Shader Find(string name) { return new Shader(); } }
    public class Material : Object
    {
        public Material(Shader shader) { }
        public void SetTexture(string name, Texture value) { }
    }
}

namespace UnityEngine.Experimental.Rendering
{
    [Flags] public enum TextureCreationFlags { None, MipChain }
    public enum GraphicsFormat
    {
        R8_UNorm, R8G8_UNorm, R8G8B8A8_UNorm, R8G8B8A8_SRGB, R16_SFloat, R16G16_SFloat, R16G16B16A16_SFloat
    }
}

namespace UnityEditor
{
    public class MenuItem : Attribute { public MenuItem(string name) { } }
    public static class Selection { public static UnityEngine.Object activeObject; }
    public static class AssetDatabase
    {
        public static string GetAssetPath(UnityEngine.Object asset) { return ""; }
        public static bool IsValidFolder(string path) { return true; }
        public static T LoadAssetAtPath<T>(string path) where T : UnityEngine.Object { return null; }
        public static void CreateAsset(UnityEngine.Object asset, string path) { }
    }
}

namespace UnityEditor.AssetImporters
{
    public class ScriptedImporterAttribute : Attribute { public ScriptedImporterAttribute(int version, string ext) { } }
    public class AssetImportContext
    {
        public string assetPath;
        public UnityEngine.Object Main;
        public void AddObjectToAsset(string id, UnityEngine.Object asset) { }
        public void SetMainObject(UnityEngine.Object asset) { Main = asset; }
    }
    public abstract class ScriptedImporter { public abstract void OnImportAsset(AssetImportContext context); }
}

public static class Program
{
    public static void Main(string[] paths)
    {
        foreach (string path in paths)
        {
            var context = new UnityEditor.AssetImporters.AssetImportContext { assetPath = path };
            new TilewrightImporter().OnImportAsset(context);
            var texture = (UnityEngine.Texture)context.Main;
            Console.WriteLine(texture.wrapMode + " " + texture.filterMode);
            foreach (string line in texture.Said) Console.WriteLine(line);
        }
    }
}

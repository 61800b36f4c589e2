// Imports the .twdds files beside it (DDS with the header of Direct3D 10) with the mip levels they hold, and
// makes a material of them: right-click the folder, Create, Tilewright Material. Unity 2021.2 or later.
using System;
using System.IO;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

[ScriptedImporter(1, "twdds")]
public class TilewrightImporter : ScriptedImporter
{
    const int Header = 148;
    // {{^toned}}
    const bool IsArray = {{array}};
    // {{/toned}}
    // {{#toned}}
    static readonly string[] Tones = { {{tones}} };  // single pictures
    bool IsArray;
    // {{/toned}}

    public override void OnImportAsset(AssetImportContext context)
    {
        // {{#toned}}
        bool isTone = Array.IndexOf(Tones, Path.GetFileName(context.assetPath)) >= 0;
        IsArray = {{array}} && !isTone;
        // {{/toned}}
        byte[] file = File.ReadAllBytes(context.assetPath);
        int height = BitConverter.ToInt32(file, 12), width = BitConverter.ToInt32(file, 16);
        int levels = BitConverter.ToInt32(file, 28), layers = BitConverter.ToInt32(file, 140);
        GraphicsFormat format = Format(BitConverter.ToInt32(file, 128), out int texel);
        const TextureCreationFlags flags = TextureCreationFlags.MipChain;
        var array = IsArray ? new Texture2DArray(width, height, layers, format, flags, levels) : null;
        var single = IsArray ? null : new Texture2D(width, height, format, levels, flags);
        int at = Header;
        for (int layer = 0; layer < layers; layer++)
            for (int level = 0; level < levels; level++)
            {
                int count = Math.Max(1, width >> level) * Math.Max(1, height >> level) * texel;
                byte[] texels = new byte[count];
                Array.Copy(file, at, texels, 0, count);
                at += count;
                if (IsArray) array.SetPixelData(texels, level, layer);
                else single.SetPixelData(texels, level);
            }
        if (IsArray) array.Apply(false, true);
        else single.Apply(false, true);
        Texture texture = IsArray ? (Texture)array : single;
        texture.filterMode = FilterMode.Trilinear;
        texture.anisoLevel = 8;
        // {{^toned}}
        texture.wrapMode = IsArray ? TextureWrapMode.Clamp : TextureWrapMode.Repeat;
        // {{/toned}}
        // {{#toned}}
        texture.wrapMode = IsArray || isTone ? TextureWrapMode.Clamp : TextureWrapMode.Repeat;
        // {{/toned}}
        context.AddObjectToAsset("texture", texture);
        context.SetMainObject(texture);
    }

    static GraphicsFormat Format(int dxgi, out int texel)
    {
        switch (dxgi)
        {
            case 61: texel = 1; return GraphicsFormat.R8_UNorm;
            case 49: texel = 2; return GraphicsFormat.R8G8_UNorm;
            case 28: texel = 4; return GraphicsFormat.R8G8B8A8_UNorm;
            case 29: texel = 4; return GraphicsFormat.R8G8B8A8_SRGB;
            case 54: texel = 2; return GraphicsFormat.R16_SFloat;
            case 34: texel = 4; return GraphicsFormat.R16G16_SFloat;
            case 10: texel = 8; return GraphicsFormat.R16G16B16A16_SFloat;
            default: throw new InvalidDataException("not a texture of tilewright");
        }
    }

    [MenuItem("Assets/Create/Tilewright Material")]
    static void Create()
    {
        string folder = AssetDatabase.GetAssetPath(Selection.activeObject);
        if (!AssetDatabase.IsValidFolder(folder)) folder = Path.GetDirectoryName(folder);
        var material = new Material(Shader.Find("Tilewright/Lit"));
        foreach (var map in new[] { {{maps}} })
            material.SetTexture(map.Item1, AssetDatabase.LoadAssetAtPath<Texture>(folder + "/" + map.Item2));
        AssetDatabase.CreateAsset(material, folder + "/Tilewright.mat");
    }
}
